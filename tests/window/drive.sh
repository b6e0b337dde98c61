# Shared by the scripts that drive the studio's window with xdotool: starts again under Xvfb where it is not there yet, and
# gives a folder `work` that goes with the script, the file `layout` in it, and a configuration of its own.
if [ -z "${CREST_IN_XVFB:-}" ]; then
  CREST_IN_XVFB=1 exec xvfb-run -a -s "-screen 0 ${SIZE:-1720x1160}x24" "$0" "$@"
fi
work=$(mktemp -d)
trap 'kill %1 2>/dev/null || true; rm -rf "$work"' EXIT
layout=$work/layout
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state XDG_DATA_HOME=$work/data

fail() { echo "FAILED: $*" >&2; exit 1; }

# value_of NAME: what stands behind it in the layout file.
value_of() { awk -F '\t' -v name="$1" '$1 == name { $1 = ""; print substr($0, 2) }' "$layout" 2>/dev/null; }

# wait_for SECONDS WORDS...: until the command given is true.
wait_for() {
  local tries=$(($1 * 20))
  shift
  until "$@"; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || fail "waited in vain for: $*"
    sleep 0.05
  done
}
is_idle() { [ "$(value_of busy)" = 0 ]; }
title_is() { [[ "$(value_of title)" == $1 ]]; }
has_widget() { [ -n "$(value_of "$1")" ]; }

# place NAME: "x y" of the widget's middle.
place() { has_widget "$1" || fail "no widget is called $1"; value_of "$1"; }

# click NAME: on the widget's middle. The mouse rests there first: Dear ImGui's tabs want to be hovered for a frame.
click() {
  xdotool mousemove $(place "$1")
  sleep 0.2
  xdotool click 1
}

# drag "x y" DX DY STEPS: with the left button, in small steps.
drag() {
  local x y i
  read -r x y <<<"$1"
  xdotool mousemove "$x" "$y"
  sleep 0.2
  xdotool mousedown 1
  for ((i = 1; i <= $4; i++)); do
    xdotool mousemove $((x + $2 * i / $4)) $((y + $3 * i / $4))
    sleep 0.03
  done
  xdotool mouseup 1
}

# type_path PATH WORDS...: into the file dialog, again and again until the command is true: on a busy machine keys get lost.
type_path() {
  local path=$1
  shift
  for _ in 1 2 3 4 5; do
    wait_for 10 has_widget "file name"
    sleep 0.5
    xdotool key ctrl+a
    sleep 0.2
    xdotool type --delay 50 "$path"
    sleep 0.2
    xdotool key Return
    for _ in $(seq 40); do
      "$@" && return
      sleep 0.05
    done
  done
  fail "$path is not taken"
}
