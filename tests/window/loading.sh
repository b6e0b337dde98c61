#!/usr/bin/env bash
# loading.sh PROGRAM SCREENSHOT: the window is there while a volume is read, reading can be cancelled, and quitting does not
# wait for it. What describes the volume is a pipe into which nobody writes: reading it takes for ever.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
touch "$work/endless.raw"
mkfifo "$work/endless.raw.json"

timeout 100 "$program" "$work/endless.raw" --preset dirac-shell --log-layout "$layout" &
wait_for 30 has_widget 'cancel loading'
[ "$(value_of busy)" = 1 ] || fail "not busy while a volume is read"
import -window root "$screenshot"
click 'cancel loading'
wait_for 10 is_idle
has_widget 'cancel loading' && fail "cancelled, and yet it reads"
has_widget example/0 || fail "no start page"
xdotool key ctrl+q
wait %1 || fail "after cancelling: exit code $?"

rm "$layout"
timeout 100 "$program" "$work/endless.raw" --log-layout "$layout" &
wait_for 30 has_widget 'cancel loading'
xdotool key ctrl+q
wait %1 || fail "while reading: exit code $?"
echo "PASSED"
