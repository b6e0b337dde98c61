#!/usr/bin/env bash
# program.sh BUILD: what is packaged as the program runs from where it is installed: it finds the program that reads files,
# and its modules.
set -eu
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --component program --prefix "$work/here" >/dev/null
printf 'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n1 2 3 4 5 6 7 8\n' >"$work/a.nrrd"
"$work/here/bin/crest" info "$work/a.nrrd" | grep -q '"dims": \[2, 2, 2\]'
"$work/here/bin/crest" render "$work/a.nrrd" --preset onion --size 8x8 --engine reference -o "$work/a.png"
[ -s "$work/a.png" ]
