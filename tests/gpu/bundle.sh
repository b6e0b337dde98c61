#!/usr/bin/env bash
# bundle.sh SOURCE BUILD: makes BUILD/gpu/crest-gpu.tar.gz, which runs the GL tests and the benchmarks on any x86-64
# Linux with a graphics driver, and BUILD/gpu/run.sh, which unpacks it (docs/gpu.md).
set -euo pipefail
source=$1 build=$2
limit_mib=60
programs=(app/crest tests/gpu_check tests/bench_frames tests/bench_speed tests/bench_features tests/test_resources
  tests/test_raycaster tests/test_vdls tests/test_convergence tests/test_stability)
module=tests/libgpu_pictures.so

out=$build/gpu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
root=$folder/crest-gpu
mkdir -p "$out" "$root"/{bin,lib,c,cxx,base,gl,render,tests/data}
for program in "${programs[@]}"; do cp "$build/$program" "$root/bin"; done
cp "$build/$module" "$root/render/libcrest_image_files.so"
# The program that reads pictures, by the loader that run.sh chooses.
cp "$build/render/crest-reader" "$root/bin"
printf '%s\n' '#!/bin/sh' 'exec ${CREST_LOADER:-} "$(dirname "$0")/../bin/crest-reader" "$@"' >"$root/render/crest-reader"
chmod +x "$root/render/crest-reader"
cp -r "$source/render/shaders" "$root/render"
cp -r "$source/tests/data/golden" "$root/tests/data"
cp "$source/tests/gpu/run.sh" "$source/docs/gpu.md" "$root"

# c: the C library, with its loader; cxx: the C++ library; base: what drivers use too; lib: what is ours alone.
while read -r name file; do
  case $name in
  libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libresolv.so.* | libutil.so.*) part=c ;;
  libstdc++.so.* | libgcc_s.so.*) part=cxx ;;
  libz.so.* | libX*.so.* | libxcb*.so.* | libbsd.so.* | libmd.so.*) part=base ;;
  *) part=lib ;;
  esac
  cp -L "$file" "$root/$part/$name"
done < <(ldd "$root"/bin/* "$root/render/libcrest_image_files.so" | awk '$2 == "=>" && $3 ~ "^/" { print $1, $3 }' | sort -u)
interpreter=$(ldd "$build/app/crest" | awk '$1 ~ "/ld-linux" { print $1 }')
cp -L "$interpreter" "$root/bin/ld.so"
# Drivers may ask for parts of the C library that we do not.
for name in librt.so.1 libdl.so.2 libpthread.so.0 libresolv.so.2 libutil.so.1 libmvec.so.1; do
  file=$(dirname "$(readlink -f "$interpreter")")/$name
  [ ! -e "$file" ] || cp -L "$file" "$root/c/$name"
done
# The dispatch between drivers (libglvnd), for containers that have none; no driver is in the bundle.
for name in libEGL.so.1 libGLdispatch.so.0 libOpenGL.so.0; do
  file=$(ldconfig -p | awk -v name="$name" '$1 == name && /x86-64/ && !seen++ { print $NF }')
  cp -L "$file" "$root/gl/$name"
done

chmod -R u+w "$root"
find "$root" -type f \( -name '*.so*' -o -path '*/bin/*' \) -exec strip --strip-unneeded {} +
tar -C "$folder" --owner=0 --group=0 --sort=name -czf "$folder/crest-gpu.tar.gz" crest-gpu
bytes=$(stat -c %s "$folder/crest-gpu.tar.gz")
[ "$bytes" -lt $((limit_mib << 20)) ] || { echo "bundle.sh: $bytes bytes are over $limit_mib MiB" >&2; exit 1; }
mv "$folder/crest-gpu.tar.gz" "$out/crest-gpu.tar.gz"
cp "$source/tests/gpu/run.sh" "$out/run.sh"
echo "$out/crest-gpu.tar.gz: $((bytes >> 20)) MiB"
