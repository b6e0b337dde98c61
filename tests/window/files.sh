#!/usr/bin/env bash
# files.sh PROGRAM SCREENSHOT: the title tells the truth after the library, an edit, Save, undo and New; what would lose
# unsaved changes asks first and says what they are; a click in the list of steps goes back.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"

timeout 200 "$program" "builtin:sphere?n=48" --preset onion --log-layout "$layout" &
wait_for 60 has_widget view0
wait_for 60 is_idle
title_is 'onion (library) - *' || fail "title of a preset of the library: $(value_of title)"

drag "$(place point/2)" 20 -80 10
wait_for 10 title_is '\* onion (library) - *'
click tab/History
wait_for 10 has_widget history/1
wait_for 60 is_idle
import -window root "$screenshot"

# Save asks for a name, since a preset of the library is not the person's file
xdotool key ctrl+s
type_path "$work/mine" title_is 'mine.json - *'
[ -s "$work/mine.json" ] || fail "nothing was saved"

# Back by one step, in the same file; on again
click history/0
wait_for 10 title_is '\* mine.json - *'
click history/1
wait_for 10 title_is 'mine.json - *'
click history/0
wait_for 10 title_is '\* mine.json - *'

# New asks; Esc stays, Discard goes on
click menu/Preset
wait_for 10 has_widget New
click New
wait_for 10 has_widget Stay
sleep 0.3
import -window root "${screenshot%.png}-question.png"
xdotool key Escape
sleep 0.5
title_is '\* mine.json - *' || fail "Esc did not stay: $(value_of title)"
click menu/Preset
wait_for 10 has_widget New
click New
wait_for 10 has_widget Discard
sleep 0.3
click Discard
wait_for 10 title_is 'new preset - *'
xdotool key ctrl+z
wait_for 10 title_is '\* mine.json - *'
xdotool key ctrl+shift+z
wait_for 10 title_is 'new preset - *'
xdotool key ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
