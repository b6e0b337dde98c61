#!/usr/bin/env bash
# paraview.sh CREST: what is exported to ParaView and VTK is there what it was here. Skipped (77) where they are not
# installed (tests/peers/install.sh).
set -euo pipefail
crest=$1
here=$(dirname "$(readlink -f "$0")")
for tool in pvpython pvbatch xvfb-run compare; do
  command -v $tool >/dev/null || { echo "skipped: no $tool here (tests/peers/install.sh brings ParaView)"; exit 77; }
done
# One display for all, which does not start anew when its last window goes: who comes at that moment is refused
if [ -z "${CREST_IN_XVFB:-}" ]; then
  CREST_IN_XVFB=1 exec xvfb-run -a -s "-noreset -screen 0 640x480x24" "$0" "$@"
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work XDG_CONFIG_HOME=$work/config  # ParaView keeps imported presets there
failed=0

# The functions: ten random presets, in ParaView and as a vtkVolumeProperty
mkdir "$work/presets"
python3 - "$work/presets" "$here" <<'P'
import random, sys
sys.path.insert(0, sys.argv[2])
import tf
rng = random.Random(11)
for i in range(10):
    tf.save(tf.random_preset(rng), "%s/%d.preset.json" % (sys.argv[1], i))
P
for preset in "$work"/presets/*.preset.json; do
  "$crest" export "$preset" --to paraview -o "${preset%.preset.json}.pv.json" 2>/dev/null
done
pvpython "$here/paraview_presets.py" "$work/presets" || failed=1
for number in 0 1; do
  # DVR_ONLY: the property holds the whole function, spikes and all
  sed 's/"transfer_function"/"rendering": {"mode": "DVR_ONLY"}, &/' "$work/presets/$number.preset.json" >"$work/dvr.json"
  "$crest" export "$work/dvr.json" --to vtk-python -o "$work/exported.py" 2>/dev/null
  pvpython "$here/vtk_property.py" "$work/exported.py" "$work/dvr.json" || failed=1
done

# The pictures: a ball of 40^3, smooth and with a spike, in Crest and in ParaView on one process and on two
volume=$work/ball_40x40x40_float32.raw
python3 -c "
import array, math
n = 40
array.array('f', [1 - math.dist((x, y, z), (19.5, 19.5, 19.5)) / 34 for z in range(n) for y in range(n) for x in range(n)]).tofile(open('$volume', 'wb'))"
camera='"camera": {"eye": [70, -80, 60], "target": [19.5, 19.5, 19.5], "up": [0, 0, 1], "fov_y_degrees": 30}'
points() { printf '"transfer_function": {"unit_distance": 8, "points": [%s]}' "$1"; }
p() { printf '{"value": %s, "opacity": %s, "color": [%s]}' "$1" "$2" "$3"; }
smooth=$(points "$(p 0.3 0 '0.2, 0.4, 1'), $(p 0.6 0.3 '0.2, 0.8, 0.6'), $(p 1 0.6 '1, 0.6, 0.2')")
spike=$(points "$(p 0.3 0.02 '0.2, 0.4, 1'), $(p 0.6999 0.1 '0.2, 0.8, 0.6'), $(p 0.7 0.9 '1, 0.4, 0.2'), $(p 0.7001 0.1 '0.2, 0.8, 0.6'), $(p 1 0.2 '1, 1, 1')")
echo "{$smooth, $camera, \"rendering\": {\"mode\": \"DVR_ONLY\"}}" >"$work/smooth.json"
echo "{$spike, $camera, \"rendering\": {\"mode\": \"PEAK_XOR_DVR\"}}" >"$work/spike.json"

# off PICTURE PICTURE MOST: their RMSE over all channels, which may be so much
off() {
  local rmse
  rmse=$(compare -metric RMSE "$1" "$2" null: 2>&1 | sed -E 's/.*\((.*)\)/\1/' || true)
  if [[ "$rmse" =~ ^[0-9.e-]+$ ]] && awk -v a="$rmse" -v most="$3" 'BEGIN { exit !(a + 0 <= most) }'; then echo "ok     $4: RMSE $rmse (at most $3)"; else
    echo "FAILED $4: RMSE $rmse, more than $3"; failed=1; fi
}
render() { "$crest" render "$volume" --preset "$work/$1.json" --engine reference --size 160x160 -o "$work/$1.png"; }
render smooth
render spike
for scene in smooth spike; do
  "$crest" export "$work/$scene.json" --to paraview-script --volume "$volume" --size 160x160 -o "$work/script.py" 2>/dev/null
  pvbatch "$work/script.py" "$volume" "$work/$scene-1.png" 2>"$work/log" || { cat "$work/log"; failed=1; }
  off "$work/$scene.png" "$work/$scene-1.png" "$([ $scene = smooth ] && echo 0.002 || echo 0.02)" "ParaView, $scene"
  command -v mpirun >/dev/null || { echo "skipped: no mpirun, the script on two processes"; continue; }
  mpirun --allow-run-as-root --oversubscribe -n 2 pvbatch "$work/script.py" "$volume" "$work/$scene-2.png" \
    2>"$work/log" || { cat "$work/log"; failed=1; }
  off "$work/$scene-1.png" "$work/$scene-2.png" 0.004 "ParaView, $scene, on two processes and on one"
done
"$crest" export "$work/smooth.json" --to vtk-python -o "$work/exported.py" 2>/dev/null
pvpython "$here/vtk_property.py" "$work/exported.py" "$work/smooth.json" "$volume" 40 "$work/cpu.png" || failed=1
off "$work/smooth.png" "$work/cpu.png" 0.01 "VTK's CPU ray caster, smooth"
[ -z "${CREST_KEEP:-}" ] || cp -r "$work" "$CREST_KEEP"
exit $failed
