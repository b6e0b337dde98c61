#!/usr/bin/env bash
# ten_tasks.sh PROGRAM SCREENSHOT [VOLUME]: what a person does from the start page to a preset in ParaView, and after a crash; a
# screenshot of each task, and how many actions it took: a click, a drag, a key, a typed text are one each.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
volume=${3:-$work/head_48x48x48_int16.raw}
tasks=0 actions=0
act() { actions=$((actions + 1)); "$@"; }
press() { xdotool key "$1"; }
type_text() { xdotool type --delay 50 -- "$1"; sleep 0.3; }
enter() { wait_for 10 has_widget typing; type_text "$1"; }
not_typing() { ! has_widget typing; }
rests() { wait_for 10 not_typing; wait_for 120 is_idle; }
peaks_are() { has_widget "peak$(($1 - 1))" && ! has_widget "peak$1"; }

# done_with TASK MOST: tells its number of actions, which may be so many at most.
done_with() {
  tasks=$((tasks + 1))
  sleep 0.5
  import -window root "${screenshot%.png}-$tasks.png"
  echo "$tasks. $1: $actions actions"
  [ $actions -le "$2" ] || fail "$1 took $actions actions, and should take $2"
  actions=0
}
# choose MENU ENTRY: from a view's menu.
choose() { act click "$1"; wait_for 10 has_widget "$2"; act click "$2"; }
# path_typed PATH WORDS...: a text and Enter.
path_typed() { actions=$((actions + 2)); type_path "$@"; }
start() {
  rm -f "$layout"
  "$program" --log-layout "$layout" &
  pid=$!
  trap 'kill -9 $pid 2>/dev/null || true; rm -rf "$work"' EXIT
  wait_for 60 has_widget "start/Open volume..."
  wait_for 60 is_idle
}

# A head of three materials, in Hounsfield units: air, what is soft, bone
[ -f "$volume" ] || perl -e '
  binmode STDOUT;
  for my $z (0..47) { for my $y (0..47) { for my $x (0..47) {
    my $r = sqrt(($x - 23.5)**2 + ($y - 23.5)**2 + ($z - 23.5)**2);
    my $soft = 1 / (1 + exp(($r - 20) / 0.7)), $bone = 1 / (1 + exp((abs($r - 14) - 2) / 0.5));
    print pack "s<", -1000 + 1040 * $soft + 900 * $bone } } }' >"$volume"

start
done_with "the start page" 0

act click "start/Open volume..."
path_typed "$volume" has_widget view0
wait_for 120 is_idle
done_with "open a CT" 4

act click menu/Preset
wait_for 10 has_widget New
act click New
rests
for value in -300 300 700; do
  act click "add peak"
  act enter $value
done
act press Return
rests
act press s
act enter 500
act press Return
rests
wait_for 10 peaks_are 3
done_with "three typed spikes and a step" 14

act click peak1.eye
wait_for 120 is_idle
done_with "hide one" 2

choose compare0 "with view1"
wait_for 120 is_idle
act drag "$(place view0)" -60 0 6
wait_for 120 is_idle
done_with "compare with the divider" 4

xdotool mousemove $(place view2)
sleep 0.5
act xdotool click 1
wait_for 20 has_widget "ray plots"
wait_for 120 is_idle
done_with "inspect a ray" 1

act xdotool click 3
wait_for 10 has_widget "select peak"
act click "select peak"
wait_for 120 is_idle
done_with "pick a surface" 2

act press ctrl+s
path_typed "$work/mine" title_is 'mine.json - *'
done_with "save" 3

act press ctrl+e
wait_for 10 has_widget export/paraview
act click export/paraview
act click "export to file"
path_typed "$work/paraview.json" test -s "$work/paraview.json"
grep -q '"RGBPoints"' "$work/paraview.json" || fail "that is no colour map of ParaView's"
press Escape
done_with "export to ParaView" 5

drag "$(place point/1)" 10 -40 6
wait_for 10 title_is '\* mine.json*'
kept() { ls "$work"/state/crest/recovery/*.json 2>/dev/null; }
wait_for 20 kept >/dev/null
kill -9 $pid
wait $pid 2>/dev/null || true
start
wait_for 10 has_widget recovery/Restore
act click recovery/Restore
wait_for 60 title_is '\* mine.json*'
wait_for 120 is_idle
done_with "recover after kill -9" 1
press ctrl+s
wait_for 10 title_is 'mine.json*'
press ctrl+q
wait $pid || fail "exit code $?"
echo "PASSED"
