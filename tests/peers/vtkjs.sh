#!/usr/bin/env bash
# vtkjs.sh CREST NODE_MODULES: what is exported to vtk.js is there what it was here. Skipped (77) where it is not installed
# (tests/peers/install.sh).
set -euo pipefail
crest=$1 modules=$2
here=$(dirname "$(readlink -f "$0")")
command -v node >/dev/null && [ -d "$modules/@kitware/vtk.js" ] ||
  { echo "skipped: no node here, or no vtk.js in $modules (tests/peers/install.sh brings it)"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 - "$work" "$here" <<'P'
import random, sys
sys.path.insert(0, sys.argv[2])
import tf
rng = random.Random(12)
for i in range(10):
    tf.save(tf.random_preset(rng), "%s/%d.preset.json" % (sys.argv[1], i))
P
for preset in "$work"/*.preset.json; do
  "$crest" export "$preset" --to vtkjs -o "${preset%.preset.json}.vtkjs.json" 2>/dev/null
done
node "$here/vtkjs.mjs" "$modules" "$work"
