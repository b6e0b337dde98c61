#!/usr/bin/env bash
# recovery.sh PROGRAM PRESET SCREENSHOT: an edit outlives kill -9: the next start offers it, one click brings it back.
set -eu
program=$1 preset=$2 screenshot=$3
source "$(dirname "$0")/drive.sh"
cp "$preset" "$work/preset.json"
kept() { ls "$work"/state/crest/recovery/*.json 2>/dev/null; }
has_kept() { kept >/dev/null; }
nothing_kept() { ! has_kept; }
has_no_offer() { ! has_widget recovery/Restore; }

# start WIDGET ARGS...: the program, until its window has that and rests.
start() {
  local widget=$1
  shift
  rm -f "$layout"
  "$program" "$@" --log-layout "$layout" &
  pid=$!
  trap 'kill -9 $pid 2>/dev/null || true; rm -rf "$work"' EXIT
  wait_for 60 has_widget "$widget"
  wait_for 60 is_idle
}

start view0 "builtin:plume?n=48" --preset "$work/preset.json"
has_no_offer || fail "something is offered at the first start"
drag "$(place point/2)" 20 -80 10
wait_for 10 title_is '\* preset.json*'
wait_for 20 has_kept
edited=$(grep -o '"opacity": [0-9.e-]*' "$(kept)")
kill -9 $pid
wait $pid 2>/dev/null || true

# Without any argument: the edit brings its volume and its preset's name with it
start "start/Open volume..."
wait_for 10 has_widget recovery/Restore
title_is 'new preset - no volume*' || fail "title before it is restored: $(value_of title)"
import -window root "$screenshot"
click recovery/Restore
wait_for 30 title_is '\* preset.json - plume*'
wait_for 60 is_idle
has_no_offer || fail "it is still offered"
import -window root "${screenshot%.png}-restored.png"

# A second crash just after loses nothing
kill -9 $pid
wait $pid 2>/dev/null || true
start "start/Open volume..."
wait_for 10 has_widget recovery/Restore
click recovery/Restore
wait_for 30 title_is '\* preset.json - plume*'
xdotool key ctrl+s
wait_for 10 title_is 'preset.json*'
[ "$(grep -o '"opacity": [0-9.e-]*' "$work/preset.json")" = "$edited" ] || fail "the edit did not come back"
wait_for 10 nothing_kept
xdotool key ctrl+q
wait $pid || fail "exit code $?"
nothing_kept || fail "something is kept of what was saved"
echo "PASSED"
