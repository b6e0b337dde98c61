#!/usr/bin/env bash
# tests/fuzz/run.sh [SECONDS [TARGET...]]: has libFuzzer look for inputs that a target does not take, each for some seconds
# (60), all targets or these, and prints what it tried. The corpora, in build/fuzz/corpus, begin with generated seeds and grow
# from run to run; what was found lies in build/fuzz/finds, and is shown by
#   build/fuzz/tests/fuzz/crest_fuzz --target=TARGET FILE
# Needs clang with libFuzzer, of Debian's clang and libclang-rt-14-dev. Ends with 1 where there are finds.
set -euo pipefail
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
seconds=${1:-60}
shift || true
folder=$root/build/fuzz fuzz=$root/build/fuzz/tests/fuzz/crest_fuzz

command -v clang++ >/dev/null || { echo "tests/fuzz/run.sh: no clang++: apt-get install clang libclang-rt-14-dev" >&2; exit 2; }
cmake -S "$root" -B "$folder" -G Ninja -DCREST_FUZZ=ON -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_C_COMPILER=clang >/dev/null
ninja -C "$folder" crest_fuzz >&2
mkdir -p "$folder/finds" "$folder/logs"
TMPDIR=$(mktemp -d -p "$([ -d /dev/shm ] && echo /dev/shm || echo /tmp)")
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
[ $# -gt 0 ] || mapfile -t all < <("$fuzz")
[ $# -gt 0 ] && all=("$@")

# A target has 10 s of wall time for an input, since others may run beside it, and may ask for 128 MiB at once. The readers are
# allowed 16.
fuzz_one() {
  "$fuzz" --target="$1" --seeds="$folder/seeds/$1" --words="$folder/seeds/$1.dict" -max_total_time="$seconds" -timeout=10 \
    -rss_limit_mb=2048 -malloc_limit_mb=128 -max_len=4096 -dict="$folder/seeds/$1.dict" -artifact_prefix="$folder/finds/$1-" \
    -print_final_stats=1 -verbosity=1 "$folder/corpus/$1" "$folder/seeds/$1" >"$folder/logs/$1" 2>&1
}

total=0 finds=0
printf '%-10s %10s %8s  %s\n' target inputs edges finds
for target in "${all[@]}"; do
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target"
  find=-
  fuzz_one "$target" || { find=$(sed -nE 's/^.*Test unit written to (.*)/\1/p' "$folder/logs/$target" | tail -1) finds=$((finds + 1)); }
  inputs=$(sed -nE 's/^stat::number_of_executed_units: *//p' "$folder/logs/$target")
  inputs=${inputs:-$(sed -nE 's/^#([0-9]+).*/\1/p' "$folder/logs/$target" | tail -1)}
  edges=$(sed -nE 's/.* cov: ([0-9]+).*/\1/p' "$folder/logs/$target" | tail -1)
  printf '%-10s %10s %8s  %s\n' "$target" "${inputs:-0}" "${edges:-0}" "${find:-$folder/logs/$target}"
  total=$((total + ${inputs:-0}))
done
printf '%-10s %10s %8s  %s\n' all "$total" "" "$finds"
[ "$finds" -eq 0 ]
