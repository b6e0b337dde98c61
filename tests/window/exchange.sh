#!/usr/bin/env bash
# exchange.sh PROGRAM SCREENSHOT: the window for exports, with its preview, writes a file; another program's file is opened,
# its opacities alone; a colour map leaves opacities as they are.
set -eu
program=$1 screenshot=$2
source "$(dirname "$0")/drive.sh"
cp "$(dirname "$0")/../../presets/library/dirac-shell.json" "$work/preset.json"
cat >"$work/map.json" <<'J'
[{"Name": "ramp", "RGBPoints": [-0.7, 0, 0, 1, 0.9, 1, 0, 0], "Points": [-0.7, 0, 0.5, 0, 0.9, 0.75, 0.5, 0]},
 {"Name": "other", "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1]}]
J

timeout 200 "$program" "builtin:sphere?n=48" --preset "$work/preset.json" --log-layout "$layout" &
wait_for 30 has_widget view0
wait_for 60 is_idle

# click_for NAME WIDGET: clicks until the widget is there: a window that just opened may miss a click.
click_for() {
  for _ in 1 2 3; do
    click "$1"
    for _ in $(seq 120); do
      has_widget "$2" && return
      sleep 0.05
    done
  done
  fail "$1 does not bring $2"
}

# Out, as a table of 256 rows, beside what it will look like there
xdotool key ctrl+e
wait_for 10 has_widget export/1dt
click_for export/1dt "##automatic rows"
click_for "##automatic rows" "##rows"
click_for "##export preview" "export picture"
wait_for 60 is_idle
sleep 2
import -window root "$screenshot"
click "export to file"
type_path "$work/out.1dt" test -s "$work/out.1dt"
[ "$(head -1 "$work/out.1dt")" = 256 ] || fail "the table has $(head -1 "$work/out.1dt") rows"
title_is 'preset.json - *' || fail "an export changed the preset: $(value_of title)"

# In: of two colour maps the first, its opacities alone
xdotool key ctrl+shift+o
type_path "$work/map.json" has_widget import/1
import -window root "${screenshot%.png}-import.png"
click import/0
click "opacities only"
click "take import"
wait_for 10 title_is '\* preset.json*'
xdotool key ctrl+s
wait_for 10 title_is 'preset.json*'
grep -q '"opacity": 0.75' "$work/preset.json" || fail "the opacities of the file are not in the preset"

# A colour map on the points: their opacities stay
before=$(grep -o '"opacity": [0-9.e-]*' "$work/preset.json")
click_for menu/Preset menu/Colours
click_for menu/Colours viridis
click viridis
wait_for 10 title_is '\* preset.json*'
xdotool key Escape
xdotool key ctrl+s
wait_for 10 title_is 'preset.json*'
grep -q '0.267004' "$work/preset.json" || fail "the colours of viridis are not in the preset"
[ "$(grep -o '"opacity": [0-9.e-]*' "$work/preset.json")" = "$before" ] || fail "a colour map changed opacities"
xdotool key ctrl+q
wait %1 || fail "exit code $?"
echo "PASSED"
