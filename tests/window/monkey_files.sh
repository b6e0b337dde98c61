# What the monkey opens: small volumes of several formats, damaged ones among them, presets, curves of other programs.

# nrrd NAME TYPE SIZES: the header; the voxels come from the standard input.
nrrd() {
  { printf 'NRRD0004\ntype: %s\ndimension: 3\nsizes: %s\nendian: little\nencoding: raw\n\n' "$2" "$3"; cat; } >"$1"
}

make_files() {
  local files=$work/files i name
  mkdir -p "$files/stack" "$files/folder"
  head -c 32768 "$program" | nrrd "$files/bytes.nrrd" uint8 "32 32 32"
  head -c 54000 "$program" | nrrd "$files/shorts.nrrd" int16 "30 30 30"
  head -c 4000 "$program" | nrrd "$files/floats.nrrd" float "10 10 10"
  head -c 12 "$program" | nrrd "$files/short.nrrd" uint8 "32 32 32" # cut
  head -c 300 "$program" >"$files/garbage.nrrd"
  head -c 8000 "$program" >"$files/unknown.raw" # its size is asked for
  : >"$files/empty.mha"
  for i in $(seq 20); do { printf 'P5\n24 24\n255\n'; head -c $((576 * i)) "$program" | tail -c 576; } >"$files/stack/$i.pgm"; done
  for name in onion dirac-shell vessels-shell; do cp "$(dirname "$0")/../../presets/library/$name.json" "$files"; done
  echo '{"version": 1, "transfer_function": 7}' >"$files/wrong.json"
  cat >"$files/map.json" <<'J'
[{"Name": "ramp", "RGBPoints": [-0.7, 0, 0, 1, 0.9, 1, 0, 0], "Points": [-0.7, 0, 0.5, 0, 0.9, 0.75, 0.5, 0]},
 {"Name": "other", "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1]}]
J
}

volumes=(bytes.nrrd shorts.nrrd floats.nrrd short.nrrd garbage.nrrd unknown.raw empty.mha stack folder missing.nrrd
  'unknown.raw?size=20x20x20&type=uint8' 'bytes.nrrd?component=3')
presets=(onion.json dirac-shell.json vessels-shell.json wrong.json map.json missing.json)
saves=(a.json b.json a.png b.png a.exr a.csv a no-folder/a.png)
