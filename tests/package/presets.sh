#!/usr/bin/env bash
# presets.sh BUILD EXAMPLE: the presets, installed as a package of their own, build and run the example.
set -eu
build=$1 example=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --component presets --prefix "$work/prefix" >"$work/log"
cmake -S "$example" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" >>"$work/log" || { cat "$work/log"; exit 1; }
cmake --build "$work/build" >>"$work/log" || { cat "$work/log"; exit 1; }
found=$("$work/build/evaluate_preset" dirac-shell 0.4)
echo "$found"
[ "$(echo "$found" | grep -c 'peak at 0.4, opacity 0.9')" = 1 ]
