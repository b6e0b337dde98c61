#!/usr/bin/env bash
# start.sh PROGRAM SCREENSHOT: the start page: an example is one click away, its pictures are made beside the window; a volume
# that was closed is among the recent ones, with its picture; undo leads back.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
export XDG_CACHE_HOME=$work/cache
has_pictures() { [ "$(ls "$work"/cache/crest/thumbnails 2>/dev/null | grep -c '^[0-9a-f]*\.png$')" -ge "$1" ]; }

timeout 200 "$program" --log-layout "$layout" &
wait_for 60 has_widget example/3
has_widget view0 && fail "views without a volume"
title_is 'new preset - no volume - *' || fail "title at the start: $(value_of title)"
wait_for 90 has_pictures 4
sleep 1
import -window root "$screenshot"

click example/0
wait_for 60 title_is 'dirac-shell (library) - plume - *'
wait_for 60 is_idle
click menu/Volume
wait_for 10 has_widget "Close volume"
click "Close volume"
wait_for 10 has_widget recent/0
title_is 'dirac-shell (library) - no volume - *' || fail "title after closing: $(value_of title)"
has_pictures 5 || fail "no picture of the volume that was closed"
xdotool mousemove 800 900
sleep 1
import -window root "${screenshot%.png}-recent.png"
xdotool key ctrl+z
wait_for 60 title_is 'dirac-shell (library) - plume - *'
wait_for 60 is_idle
xdotool key ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
