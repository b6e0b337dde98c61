#!/usr/bin/env bash
# typing.sh PROGRAM SCREENSHOT: three spikes and a step at typed values, from a new preset; a number that was typed and not
# confirmed is saved; one that is wrong is refused. What takes a person how many actions is counted: a click, a typed number
# and a key are one each.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
actions=0
act() { actions=$((actions + 1)); "$@"; }
press() { xdotool key "$1"; }
enter() { wait_for 10 has_widget typing; xdotool type --delay 50 -- "$1"; sleep 0.3; }
not_typing() { ! has_widget typing; }
peaks_are() { has_widget "peak$(($1 - 1))" && ! has_widget "peak$1"; }

timeout 200 "$program" "builtin:plume?n=32" --log-layout "$layout" &
wait_for 30 has_widget view0
wait_for 60 is_idle
click values/normalized  # in which the file's numbers are those that were typed

for value in 0.3 ,5 7/10; do
  act click 'add peak'
  act enter $value
done
act press Return
wait_for 10 not_typing
act press s
act enter .25
act press Return
wait_for 10 not_typing
wait_for 10 peaks_are 3
[ $actions -le 14 ] || fail "three spikes and a step took $actions actions"
echo "three spikes and a step: $actions actions"
wait_for 60 is_idle
import -window root "$screenshot"

# Refused, and then typed and not confirmed: Ctrl+S takes it
click '##opacity'
enter 1,5
press Return
wait_for 10 has_widget '##opacity/refused'
click '##opacity'
enter .625
press ctrl+s
wait_for 10 has_widget 'file name'
for _ in 1 2 3 4 5; do
  sleep 0.5
  press ctrl+a
  sleep 0.2
  xdotool type --delay 50 "$work/typed.json"
  sleep 0.2
  press Return
  sleep 2
  [ -f "$work/typed.json" ] && break
done

for value in 0.3 0.5 0.7; do
  grep -q "\"value\": $value, .*\"opacity\": 0.8" "$work/typed.json" || fail "no spike at $value"
done
[ "$(grep -c '"value": 0.25,' "$work/typed.json")" = 2 ] || fail "no step at 0.25"
grep -q '"value": 0.25, .*"opacity": 0.625' "$work/typed.json" || fail "what was typed is lost"
press ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
