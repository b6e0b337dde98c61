#!/usr/bin/env bash
# keyboard.sh PROGRAM SCREENSHOT: without a mouse, on a French keyboard: a volume and a spike by the command palette and keys,
# the menus, and Ctrl+Z where Z is; quitting by the menu.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
setxkbmap fr 2>/dev/null || true

timeout 200 "$program" --log-layout "$layout" &
wait_for 30 has_widget "start/Open volume..."

xdotool key ctrl+shift+p
wait_for 10 has_widget "palette search"
xdotool type --delay 60 "open gyr"
wait_for 10 has_widget "palette/Open builtin:gyroid"
sleep 0.3
import -window root "${screenshot%.png}-palette.png"
xdotool key Return
wait_for 30 has_widget view0
wait_for 60 is_idle

xdotool key p
wait_for 10 has_widget typing
xdotool type --delay 60 "0.25"
xdotool key Return
is_taken() { ! has_widget typing; }
wait_for 20 is_taken
wait_for 60 is_idle
for _ in 1 2; do # the value, and the spike
  xdotool key ctrl+z
  sleep 0.5
done
wait_for 10 title_is '[!*]*'
xdotool key ctrl+shift+z
wait_for 10 title_is '\* *'

xdotool key F6
sleep 1
xdotool key F6
sleep 1
import -window root "$screenshot"
xdotool key F1
wait_for 10 has_widget "close help"
sleep 0.3
import -window root "${screenshot%.png}-help.png"
xdotool key Escape
sleep 0.5
xdotool key alt
wait_for 10 has_widget Quit
sleep 0.3
import -window root "${screenshot%.png}-menu.png"
xdotool key Up # from the first entry round to the last: Quit
sleep 1
xdotool key Return
wait_for 10 has_widget Discard
sleep 0.3
import -window root "${screenshot%.png}-question.png"
xdotool key Tab # from Save to Discard
sleep 1
xdotool key Return
wait %1 || fail "exit code $?"
echo "PASSED"
