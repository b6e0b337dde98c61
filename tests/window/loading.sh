#!/usr/bin/env bash
# loading.sh PROGRAM SCREENSHOT: the window is there while a volume is read and shows how much is, reading can be cancelled, and quitting does not
# wait for it. The program that reads is stopped in its tracks: reading takes for ever. It is gone in the end.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
mkdir "$work/stack"
for i in $(seq 10000); do printf 'P2\n2 2\n255\n0 1 2 3\n' >"$work/stack/$i.pgm"; done

reader= # its process
# Of the program that `timeout` has started as job $1; once it has seen to it that it ends with that.
stop_reader() {
  reader=$(pgrep -P "$(pgrep -P "$1")" crest-reader) && grep -q '^NoNewPrivs:.*1' "/proc/$reader/status" && kill -STOP "$reader"
}
# A little at a time, until the window shows how much is read.
read_some() {
  for ((i = 0; i < 200; ++i)); do
    kill -CONT "$reader"
    sleep 0.02
    kill -STOP "$reader"
    sleep 0.2
    has_widget 'loaded share' && return
  done
  fail "it does not show how much is read"
}
reader_is_gone() { ! kill -0 "$reader" 2>/dev/null; }
open_the_stack() {
  timeout 100 "$program" "$work/stack" --preset dirac-shell --log-layout "$layout" &
  for ((i = 0; i < 1000; ++i)); do
    stop_reader $! && break
    sleep 0.01
  done
  [ -n "$reader" ] || fail "no program reads"
  wait_for 30 has_widget 'cancel loading'
}

open_the_stack
[ "$(value_of busy)" = 1 ] || fail "not busy while a volume is read"
has_widget 'loaded share' && fail "it shows how much is read, and nothing is"
read_some
import -window root "$screenshot"
click 'cancel loading'
wait_for 10 is_idle
wait_for 10 reader_is_gone
has_widget 'cancel loading' && fail "cancelled, and yet it reads"
has_widget example/0 || fail "no start page"
xdotool key ctrl+q
wait %1 || fail "after cancelling: exit code $?"

rm "$layout"
open_the_stack
xdotool key ctrl+q
wait %1 || fail "while reading: exit code $?"
wait_for 10 reader_is_gone
echo "PASSED"
