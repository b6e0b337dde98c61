#!/usr/bin/env bash
# watch.sh PROGRAM PRESET SCREENSHOT: the studio follows its preset's file, and keeps what is not saved.
set -eu
program=$1 preset=$2 screenshot=$3
source "$(dirname "$0")/drive.sh"
cp "$preset" "$work/preset.json"

# set_opacity NUMBER: of the third point, by another program, whole at once.
set_opacity() {
  awk -v opacity="$1" '/"value":/ && ++count == 3 { sub(/"opacity": [0-9.]+/, "\"opacity\": " opacity) } { print }' \
    "$work/preset.json" >"$work/edited.json"
  mv "$work/edited.json" "$work/preset.json"
}
has_moved() { [ "$(place point/2)" != "$before" ]; }

timeout 250 "$program" "builtin:plume?n=48" --preset "$work/preset.json" --watch --log-layout "$layout" &
wait_for 60 has_widget view0
wait_for 60 is_idle
wait_for 60 is_idle
before=$(place point/2)
set_opacity 0.375
wait_for 20 has_moved
title_is 'preset.json - *' || fail "what was read again counts as unsaved: $(value_of title)"

drag "$(place point/2)" 20 40 10
sleep 1
wait_for 10 title_is '\* preset.json*'
wait_for 60 is_idle
before=$(place point/2)
set_opacity 0.625
sleep 2
! has_moved || fail "the file's change went over what was not saved"
title_is '\* preset.json*' || fail "title after a change outside: $(value_of title)"
wait_for 60 is_idle
import -window root "$screenshot"
