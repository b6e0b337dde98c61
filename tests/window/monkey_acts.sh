# What the monkey does. Every act goes through `x`, which writes it down.
x() {
  printf 'xdotool %s\n' "${*@Q}" >>"$actions"
  xdotool "$@" 2>/dev/null || true # a window that just closed is nobody's fault
}

roll() { number=$((RANDOM % $1)); } # 0 to $1 - 1, in `number`
one_of() { roll $#; shift $number; chosen=$1; }

width=1000 height=700

# The named widgets, as "x y" in `places`, by `names`. What ends the program or leads out of the folder is left out.
look() {
  local name at_x at_y
  names=() places=()
  [ -f "$layout" ] || return 0
  while IFS=$'\t' read -r name at_x at_y; do
    case $name in title | busy | Quit | "Quit anyway" | "folder up") continue ;; esac
    [ -n "$at_y" ] || continue
    [ "$at_x" -ge 0 ] && [ "$at_x" -lt $width ] && [ "$at_y" -ge 0 ] && [ "$at_y" -lt $height ] || continue
    names+=("$name") places+=("$at_x $at_y")
  done <"$layout" # not from a process: bash waits for ever for a program that gets the number of an old one
}

# The place of one whose name begins so, in `chosen`; false if there is none.
one_named() {
  local i found=()
  for i in "${!names[@]}"; do [[ "${names[i]}" != $1* ]] || found+=("${places[i]}"); done
  [ ${#found[@]} -gt 0 ] && one_of "${found[@]}"
}
shows() { [ -n "$(value_of "$1")" ]; }

anywhere() {
  roll $width; chosen=$number
  roll $height; chosen="$chosen $number"
}
click_at() { x mousemove $1 sleep 0.1 click --repeat "${3:-1}" --delay 80 "${2:-1}"; } # "x y" BUTTON TIMES

click_widget() {
  [ ${#names[@]} -gt 0 ] || return 0
  one_of "${places[@]}"
  local place=$chosen
  one_of 1 1 1 1 1 1 3 2
  local button=$chosen
  one_of 1 1 1 1 2
  click_at "$place" "$button" "$chosen"
}
click_anywhere() { anywhere; click_at "$chosen"; }
click_plot() { one_named point/ && click_at "$chosen" 1 || click_widget; }

drag_from() { # "x y" BUTTON KEY
  local from=$1 button=$2 key=$3 dx dy i
  roll 400; dx=$((number - 200))
  roll 300; dy=$((number - 150))
  [ -z "$key" ] || x keydown "$key"
  x mousemove $from sleep 0.1 mousedown "$button"
  for i in 1 2 3 4; do x mousemove_relative -- $((dx / 4)) $((dy / 4)) sleep 0.03; done
  one_of 0 0 0 0 0 0 1
  [ "$chosen" = 0 ] || x key Escape
  x mouseup "$button"
  [ -z "$key" ] || x keyup "$key"
}
drag_some() { # names that begin so
  one_named "$1" || anywhere
  local from=$chosen
  one_of 1 1 1 1 2 3
  local button=$chosen
  one_of "" "" "" shift ctrl alt
  drag_from "$from" "$button" "$chosen"
}
drag_point() { drag_some point/; }
drag_view() { drag_some view; }
drag_widget() { drag_some ""; }

scroll() {
  one_named view || anywhere
  local place=$chosen
  one_of "$place" "$place" any
  [ "$chosen" != any ] || { anywhere; place=$chosen; }
  roll 6; local times=$((number + 1))
  one_of 4 5 4 5 6 7
  click_at "$place" "$chosen" $times
}

keys=(ctrl+z ctrl+shift+z ctrl+y ctrl+x ctrl+c ctrl+v Delete BackSpace ctrl+a p s b t f r o i v n m h 1 2 3 4 ctrl+1 ctrl+2
  ctrl+3 ctrl+4 Escape Tab shift+Tab F1 F5 F6 F10 Left Right Up Down shift+Left shift+Right ctrl+Left ctrl+Right Home End
  Page_Up Page_Down space ctrl+o ctrl+shift+o ctrl+l ctrl+s ctrl+shift+s ctrl+e ctrl+p ctrl+shift+p)
press_key() {
  one_of "${keys[@]}"
  roll 4
  x key --repeat $((number + 1)) --repeat-delay 30 "$chosen"
}
press_return() { shows Quit || x key Return; } # in a menu it might be Quit
press_escape() { x key --repeat 3 --repeat-delay 60 Escape; }
storm() {
  one_of ctrl+z ctrl+shift+z
  roll 30
  x key --repeat $((number + 5)) --repeat-delay 15 "$chosen"
}

type_number() {
  one_of 0.5 0 1 -1 1e-9 1e300 0,5 nan 0.123456789 "" 50% +0.1 "*2" "1 2" 0x10 99999999999
  [ -z "$chosen" ] || x type --delay 20 -- "$chosen"
  x key Return
}
type_in_field() {
  one_named "" || return 0
  local place=$chosen
  one_of 1 2
  click_at "$place" 1 "$chosen"
  type_number
}

commands=("Open builtin:gyroid" "Open builtin:plume" "Open builtin:vessels" "Open builtin:marschner" "Open builtin:noise"
  "Open builtin:linear" "Close volume" "Open preset onion" "Open preset fire" "Open preset four" "New" "Colours: " "Carry over"
  "Fit to" "Convert to data" "Convert to norm" "Look along" "Roll to" "Parallel" "Outline" "Suggested" "Exact at rest"
  "Error bound" "Four views" "Two views" "One view" "Compare by" "Compare with" "Stop comp" "Take a snap" "Settings" "Name and"
  "Export" "Import" "Save a pic" "Library" "Go to " "Go to Acc" "Go to Rend" "Go to Peaks" "Go to Hist" "Mode in" "Show all"
  "Zoom to" "Reload" "Manual" "About" "Keys" "Reset" "zzz")
# by_palette WORDS [ROWS]: by the palette, so many rows down.
by_palette() {
  x key ctrl+shift+p sleep 0.25
  x type --delay 15 -- "$1"
  [ "${2:-0}" = 0 ] || x sleep 0.1 key --repeat "$2" Down
  x sleep 0.1 key Return
}
random_command() {
  one_of "${commands[@]}"
  local words=$chosen
  one_of 0 0 0 1 2 3
  by_palette "$words" "$chosen"
}

resize() {
  roll 1100; width=$((number + 400))
  roll 700; height=$((number + 300))
  one_of no no no yes
  [ "$chosen" = no ] || { width=1000 height=700; }
  x windowsize "$window" $width $height
}
change_look() { # of the settings: theme, size of texts
  one_named size/ || one_named theme/ || one_named "##scale" || { by_palette Settings; return; }
  click_at "$chosen"
}

# A dialog for files: mostly a path of our own, whole, so that it does not matter which folder is shown.
use_file_dialog() {
  one_of path path path path list cancel escape
  case $chosen in
    path)
      one_of "${volumes[@]/#/$work/files/}" "${presets[@]/#/$work/files/}" "${saves[@]/#/$work/saved/}"
      click_at "$(value_of "file name")"
      x key ctrl+a
      x type --delay 5 -- "$chosen"
      x sleep 0.1 key Return
      ;;
    list) one_named file/ && click_at "$chosen" 1 2 || x key Escape ;;
    cancel) click_at "$(value_of "cancel file")" ;;
    escape) x key Escape ;;
  esac
}
answer_replace() {
  one_of replace keep
  click_at "$(value_of "$chosen")"
}

acts_by_weight=(click_widget click_widget click_widget click_widget click_widget click_anywhere click_plot click_plot
  drag_point drag_point drag_point drag_view drag_view drag_widget scroll scroll press_key press_key press_key press_key
  press_key press_return press_escape storm type_in_field type_number random_command random_command random_command resize
  change_look)
act() {
  look
  if shows replace; then answer_replace; return; fi
  if shows "file name"; then use_file_dialog; return; fi
  one_of "${acts_by_weight[@]}"
  if [ "$chosen" = click_anywhere ] && shows Quit; then chosen=press_escape; fi
  "$chosen"
  one_of 0 0.02 0.1 0.3
  sleep "$chosen"
}

# until_shows WIDGET: at most some seconds.
until_shows() {
  local i
  for i in $(seq 60); do
    ! shows "$1" || return 0
    sleep 0.05
  done
  return 1
}
# surely COMMAND: by the palette, step by step, since a busy machine loses keys and repeats those that are held too long.
surely() {
  local i
  for i in 1 2 3; do
    x key Escape sleep 0.1 key Escape sleep 0.1 key ctrl+shift+p
    until_shows "palette search" || continue
    x key ctrl+a
    x type --delay 15 -- "$1"
    until_shows "palette/$1" || continue
    x key Return
    ! until_shows Discard || click_at "$(value_of Discard)"
    return 0
  done
  return 1
}

# Nothing open, a new preset, no volume, one view. False where a dialog does not go.
go_home() {
  local i
  for i in 1 2 3; do x key --repeat 4 --repeat-delay 80 Escape; done
  x windowsize "$window" 1000 700
  width=1000 height=700
  for i in "One view" New; do surely "$i" || return 1; done
  shows "start/Open volume..." || surely "Close volume" || return 1
  for i in $(seq 100); do
    if is_idle && shows "start/Open volume..."; then rest; return 0; fi
    has_ended && return 1
    sleep 0.1
  done
  return 1
}

# Until it has done nothing for a while, pictures on its start page neither: then it gives memory back (app/idle_memory.cpp).
rest() {
  local before now quiet=0 i
  before=$(ticks)
  for i in $(seq 40); do
    sleep 1
    now=$(ticks)
    if [ $((now - before)) -le 5 ]; then quiet=$((quiet + 1)); else quiet=0; fi
    before=$now
    [ $quiet -lt 8 ] || return 0
  done
}
ticks() { awk '{ print $14 + $15 }' "/proc/$pid/stat" 2>/dev/null || echo 0; } # of processor time, hundredths of a second
