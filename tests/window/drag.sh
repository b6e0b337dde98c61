#!/usr/bin/env bash
# drag.sh PROGRAM LOG [VOLUME [PRESET]]: drags a point of the TF, and then one view, about for some seconds in a real window,
# and leaves the frame times and the times from an edit to each view in LOG, as JSON. SIZE=3840x2160 in the environment: in a
# window of that size, with one view enlarged. SCREENSHOT=FILE: what is on the screen right after.
set -eu
program=$1 log=$2 volume=${3:-builtin:plume?n=128} preset=${4:-dirac-shell}
source "$(dirname "$0")/drive.sh"

timeout 300 "$program" "$volume" --preset "$preset" --log-layout "$layout" --log-frames "$log" &
wait_for 30 has_widget view0
wait_for 60 is_idle
if [ -n "${SIZE:-}" ]; then
  xdotool search --onlyvisible --name Crest windowsize ${SIZE/x/ }
  sleep 2
  xdotool key 3
  sleep 2
fi
# There and back on other ways, so that nothing is drawn that was drawn before
for by in '15 -60' '-11 57' '17 -53' '-23 41'; do
  drag "$(place point/2)" $by 60
done
[ -z "${SIZE:-}" ] || drag "$(place view2)" 200 90 60
[ -z "${SCREENSHOT:-}" ] || import -window root "$SCREENSHOT"
[ -n "${SIZE:-}" ] || wait_for 60 is_idle
# All is undone, so that nothing is asked on quitting
for _ in $(seq 60); do
  title_is '[!*]*' && break
  xdotool key ctrl+z
  sleep 0.5
done
xdotool key ctrl+q
wait %1
