#!/usr/bin/env bash
# library.sh PROGRAM SCREENSHOT: the library shows each preset on the open volume; a copy goes into the person's own folder,
# and from there to the bin; one is opened.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
export XDG_CACHE_HOME=$work/cache
own=$work/data/crest/presets
pictures() { ls "$work"/cache/crest/thumbnails 2>/dev/null | grep -c '^[0-9a-f]*\.png$' || true; }
has_pictures() { [ "$(pictures)" -ge "$1" ]; }
is_gone() { ! [ -e "$1" ]; }
lacks_widget() { ! has_widget "$1"; }

timeout 300 "$program" "builtin:vessels?n=64" --log-layout "$layout" &
wait_for 60 has_widget view0
wait_for 60 is_idle
xdotool key ctrl+l
wait_for 10 has_widget library/onion
wait_for 180 has_pictures 10
sleep 1
click library/onion
wait_for 10 has_widget library/Duplicate
sleep 0.3
import -window root "$screenshot"
click library/Duplicate
wait_for 10 test -s "$own/copy-of-onion.json"
wait_for 10 has_widget "library/$own/copy-of-onion.json"
click "library/$own/copy-of-onion.json"
wait_for 10 has_widget library/Delete
sleep 0.3
import -window root "${screenshot%.png}-own.png"
click library/Delete
wait_for 10 is_gone "$own/copy-of-onion.json"
[ -s "$work/data/Trash/files/copy-of-onion.json" ] || fail "it is not in the bin"

wait_for 10 lacks_widget "library/$own/copy-of-onion.json"
click library/onion
wait_for 10 has_widget library/Open
click library/Open
wait_for 20 title_is 'onion (library) - vessels - *'
wait_for 60 is_idle
xdotool key ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
