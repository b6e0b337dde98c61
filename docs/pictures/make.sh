#!/usr/bin/env bash
# make.sh PROGRAM: makes the manual's pictures of the window again, beside this file.
set -eu
program=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
source "$here/../../tests/window/drive.sh"
export XDG_CACHE_HOME=$work/cache

# The parts of a window of 1720x1160
all=1720x1160+0+0 views=1106x1130+0+24 editor=608x560+1112+24 tabs=608x550+1112+584
# shot NAME PART: when the window rests, with the mouse out of the way unless it was put somewhere.
shot() {
  wait_for 300 is_idle
  sleep 1
  import -window root "$work/shot.png"
  convert "$work/shot.png" -crop "$2" +repage +dither -colors 220 "PNG8:$here/$1.png"
}
away() { xdotool mousemove 1100 1155; }
press() { xdotool key "$1"; sleep 0.5; }
choose() { click "$1"; wait_for 10 has_widget "$2"; click "$2"; }
start() {
  rm -f "$layout"
  "$program" "$@" --log-layout "$layout" &
}
finish() {
  press ctrl+q
  sleep 0.5
  if has_widget Discard; then click Discard; fi
  wait %% || true
}

start
wait_for 60 has_widget example/3
has_pictures() { [ "$(ls "$work"/cache/crest/thumbnails 2>/dev/null | grep -c '^[0-9a-f]*\.png$')" -ge 4 ]; }
wait_for 120 has_pictures
away
shot start $all
finish

start "builtin:plume?n=96" --preset dirac-shell
wait_for 60 has_widget view0
away
shot window $all
cp "$here/window.png" "$here/studio.png"
choose compare0 "with view2"
wait_for 120 is_idle
drag "$(place view0)" -60 0 6
away
shot compare $views
choose compare0 "stop comparing"
wait_for 120 is_idle
xdotool mousemove $(place view2)
sleep 0.5
xdotool click 1
wait_for 60 has_widget "ray plots"
away
shot ray $tabs
click tab/Slices
away
shot slices $tabs
click tab/Peaks
press ctrl+e
wait_for 10 has_widget export/paraview
click export/paraview
away
shot export $all
press Escape
press ctrl+l
sleep 20
away
shot library $all
press Escape
press ctrl+shift+p
xdotool type --delay 60 "spike"
away
shot commands $all
press Escape
click peak0
press f
away
shot editor $editor
finish

start "builtin:marschner-lobb?n=64" --preset four-peaks
wait_for 60 has_widget view0
wait_for 120 is_idle
if has_widget "peak table"; then click "peak table"; fi
away
shot peak-table $tabs
finish
