#!/bin/sh
# Checks Crest on this machine's graphics card, and leaves result.json in the working folder (docs/gpu.md).
#   run.sh [--quick] [--minutes N] [-o FILE]
# It lies in the archive crest-gpu.tar.gz, or beside it: then it unpacks it. Only sh, tar and gzip are needed.
set -eu
PATH=${PATH:-/usr/local/bin:/usr/bin:/bin}:/usr/sbin:/sbin
export PATH
say() { echo "run.sh: $*" >&2; }

here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/crest-gpu.XXXXXX") || { say "no temporary folder: set TMPDIR"; exit 2; }
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM HUP
if [ -d "$here/bin" ]; then
  root=$here
else
  root=$work/crest-gpu
  tar -xzf "$here/crest-gpu.tar.gz" -C "$work"
fi

# Nothing is written but into the temporary folder, and the result.
mkdir -p "$work/tmp" "$work/home"
export TMPDIR="$work/tmp" HOME="$work/home" XDG_CACHE_HOME="$work/home/cache" XDG_CONFIG_HOME="$work/home/config" \
  XDG_STATE_HOME="$work/home/state" XDG_DATA_HOME="$work/home/data" CREST_TEST_FOLDER="$root"
unset DISPLAY WAYLAND_DISPLAY LD_PRELOAD || true

# The folders in which a driver may lie. The loader knows most of them, but where nobody ran ldconfig, or the
# loader is the bundle's own.
folders=
for folder in /lib/x86_64-linux-gnu /usr/lib/x86_64-linux-gnu /lib64 /usr/lib64 /usr/lib /usr/local/lib \
  /usr/local/nvidia/lib64 /usr/local/nvidia/lib /run/opengl-driver/lib /usr/lib/wsl/lib; do
  [ ! -d "$folder" ] || folders=$folders:$folder
done
given=${LD_LIBRARY_PATH:-}
unset LD_LIBRARY_PATH || true

is_there() { # a library of this machine
  for folder in $(echo "$given$folders" | tr : ' '); do [ ! -e "$folder/$1" ] || return 0; done
  ldconfig -p 2>/dev/null | grep -q "^[[:space:]]*$1 .*x86-64"
}

# The machine's own dispatch between drivers (libglvnd), or where it is not whole, the bundle's: in containers that are
# given a driver and nothing else. Its libraries are of one version, or calls go astray: they are not mixed.
gl=$root/gl
if is_there libEGL.so.1 && { is_there libOpenGL.so.0 || is_there libGL.so.1; }; then gl=$work; fi
if [ -z "${__EGL_VENDOR_LIBRARY_FILENAMES:-}${__EGL_VENDOR_LIBRARY_DIRS:-}" ]; then
  vendors=
  for folder in /etc/glvnd /usr/share/glvnd /usr/local/nvidia/share/glvnd /run/opengl-driver/share/glvnd; do
    [ ! -d "$folder/egl_vendor.d" ] || vendors=$vendors${vendors:+:}$folder/egl_vendor.d
  done
  if is_there libEGL_nvidia.so.0 && ! grep -qs EGL_nvidia $(echo "$vendors" | sed 's,:,/* ,g;s,$,/*,'); then
    mkdir "$work/vendor"
    echo '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}' >"$work/vendor/10_nvidia.json"
    vendors=$work/vendor${vendors:+:$vendors}
  fi
  [ -z "$vendors" ] || export __EGL_VENDOR_LIBRARY_DIRS="$vendors"
fi

# A driver is linked with this machine's C and C++ libraries, and needs them as new as they are here; our programs
# need them as new as in the bundle. So: this machine's; else the bundle's C++ library; else its C library too, with
# its loader. What the machine lacks of others comes from the bundle. The first way that finds a card is taken, or else
# the first that finds any driver.
lacks=$work/lacks
mkdir "$lacks"
for library in "$root"/cxx/* "$root"/base/*; do
  is_there "$(basename "$library")" || cp "$library" "$lacks"
done
ours=$root/lib:$gl:$lacks${given:+:$given}$folders
own_loader="$root/bin/ld.so --library-path $root/c:$root/cxx:$ours"
launch() { # WAY PROGRAM ARGUMENT...
  way=$1
  shift
  case $way in
  machine) env "LD_LIBRARY_PATH=$ours" "$@" ;;
  cxx) env "LD_LIBRARY_PATH=$root/cxx:$ours" "$@" ;;
  c) env "CREST_LOADER=$own_loader" $own_loader "$@" ;;
  esac
}

best= best_kind=
for way in machine cxx c; do
  [ "$best_kind" != card ] || break
  if ! device=$(launch $way "$root/bin/bench_frames" --device-only 2>"$work/why") ||
    [ "$device" != "${device#*'"renderer":""'}" ]; then
    say "libraries '$way': $(tail -n 1 "$work/why")"
    continue
  fi
  case $device in
  *llvmpipe* | *softpipe* | *swrast* | *SWR*) kind=software ;;
  *) kind=card ;;
  esac
  say "libraries '$way': $kind, $(echo "$device" | sed 's/.*"renderer":"\([^"]*\)".*/\1/')"
  [ -n "$best" ] && [ $kind = software ] || best=$way best_kind=$kind
done
[ -n "$best" ] || { say "no driver here gives an OpenGL 4.5 core context by EGL"; exit 2; }

case $best in
machine) set -- "$@" -- /usr/bin/env "LD_LIBRARY_PATH=$ours" ;;
cxx) set -- "$@" -- /usr/bin/env "LD_LIBRARY_PATH=$root/cxx:$ours" ;;
c) set -- "$@" -- /usr/bin/env "CREST_LOADER=$own_loader" $own_loader ;;
esac
launch "$best" "$root/bin/gpu_check" --programs "$root/bin" "$@"
