#!/usr/bin/env bash
# views.sh PROGRAM SCREENSHOT: a view beside another one behind a line that is dragged, their difference; a pixel's ray; a peak
# of what is under the mouse; a picture that keeps its preset.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"

timeout 200 "$program" "builtin:sphere?n=32" --preset onion --log-layout "$layout" &
wait_for 30 has_widget view0
wait_for 60 is_idle

# choose MENU ENTRY: from a view's menu.
choose() {
  click "$1"
  wait_for 10 has_widget "$2"
  click "$2"
}
choose compare0 "with view2"
wait_for 60 is_idle
drag "$(place view0)" -60 0 6
choose compare0 how/difference
xdotool key Escape
wait_for 60 is_idle

xdotool mousemove $(place view2)
sleep 0.5
xdotool click 1
wait_for 20 has_widget "ray plots"
wait_for 60 is_idle
grep -q '^ray: .* crossings 0 missed' "$layout" || fail "the ray says: $(grep '^ray:' "$layout")"
import -window root "$screenshot"

xdotool mousemove $(place view2)
sleep 0.5
xdotool click 3
wait_for 10 has_widget "select peak"
click "select peak"
sleep 0.5
xdotool key Delete
wait_for 10 title_is '\* onion*'

xdotool key ctrl+p
wait_for 10 has_widget "picture file"
sleep 0.5 # until it stands in the middle
click "picture file"
is_asked() { has_widget "file name"; }
is_answered() { ! is_asked; }
type_path "$work/out.png" is_answered
wait_for 120 test -s "$work/out.png"
"$program" render "builtin:sphere?n=16" --preset "$work/out.png" --size 16x16 -o "$work/again.png" ||
  fail "the picture keeps no preset"
xdotool key ctrl+z
wait_for 10 title_is 'onion*'
xdotool key ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
