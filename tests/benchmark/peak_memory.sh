#!/bin/bash
# peak_memory.sh COMMAND...: the most resident memory that a command and its reader take, each alone and both at
# once, in MB. It looks every 10 ms.
"$@" >/dev/null &
pid=$!
main=0 reader=0 both=0

# Of process $1, now and at most, in kB.
resident() {
  now=0 most=0
  while read -r key value _; do
    case $key in VmRSS:) now=$value ;; VmHWM:) most=$value ;; esac
  done <"/proc/$1/status"
}

while kill -0 "$pid"; do
  resident "$pid"
  own=$now
  ((most > main)) && main=$most
  children=0
  read -rd '' -a readers < <(cat "/proc/$pid/task/"*/children)
  for child in "${readers[@]}"; do
    resident "$child"
    children=$((children + now))
    ((most > reader)) && reader=$most
  done
  ((own + children > both)) && both=$((own + children))
  sleep 0.01
done 2>/dev/null
wait "$pid" || exit
echo "program $((main / 1000)) MB, reader $((reader / 1000)) MB, both at once $((both / 1000)) MB"
