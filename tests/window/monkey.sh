#!/usr/bin/env bash
# monkey.sh PROGRAM SECONDS [SEED [SCREENSHOT]]: for so long random keys, clicks, drags, turns of the wheel, sizes of the
# window, volumes and dialogs. It must not crash, must answer within two seconds (answers.cpp says how that is counted), and
# must not take more and more memory: at most 5 % once it has settled. What it writes goes into the script's folder: the
# system refuses all else (write_only_in.cpp).
# The seed chooses what is done; since the window answers at its own pace, a second run is alike, not the same. A failure
# prints the last 50 actions: lines for a shell, with a window of that size.
set -eu
program=$(realpath "$1") seconds=$2 seed=${3:-$RANDOM} screenshot=${4:+$(realpath "$4")}
tools=${CREST_TEST_PROGRAMS:-$(dirname "$program")/../tests}
[ $# -gt 2 ] || set -- "$program" "$seconds" "$seed"
source "$(dirname "$0")/drive.sh"
source "$(dirname "$0")/monkey_files.sh"
source "$(dirname "$0")/monkey_acts.sh"
RANDOM=$seed
actions=$work/actions memory=$work/memory
slowest_s=2 growth_percent=5 home_every_s=30
settled_s=$((seconds > 1800 ? seconds / 6 : 300)) # since the program began: by then the libraries have what they keep

export HOME=$work/home XDG_CACHE_HOME=$work/cache TMPDIR=$work/tmp PATH=$work/bin:$PATH
mkdir -p "$HOME" "$TMPDIR" "$work/bin" "$work/saved"
printf '#!/bin/sh\n' >"$work/bin/xdg-open" # the manual opens nothing
chmod +x "$work/bin/xdg-open"
make_files
cd "$work/files"

complain() {
  echo "FAILED after $((SECONDS - began)) s, seed $seed: $*" >&2
  echo "the last actions:" >&2
  tail -50 "$actions" >&2
  tail -5 "$work/stderr" | cut -c1-300 >&2
  [ -z "$screenshot" ] || import -window root "$screenshot" 2>/dev/null || true
  exit 1
}
fail() { complain "$@"; } # of drive.sh's, too

start() {
  rm -f "$layout"
  "$tools/write_only_in" "$work" "$program" "builtin:sphere?n=32" --preset onion --log-layout "$layout" \
    >>"$work/stderr" 2>&1 &
  pid=$! born=$SECONDS
  trap clean_up EXIT
  for _ in $(seq 600); do
    if has_widget view0; then break; fi
    if has_ended; then end_of_program; return; fi
    sleep 0.1
  done
  has_widget view0 || complain "the window did not open within a minute"
  window=$(xdotool search --pid "$pid" --name Crest | head -1)
  "$tools/answers" "$window" "$pid" $slowest_s >>"$work/answers" &
  watch=$!
  : >"$memory"
}

# What still writes there must have ended before its folder goes.
clean_up() {
  kill $watch 2>/dev/null || true
  kill -9 "$pid" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$work"
}

has_ended() { ! kill -0 "$pid" 2>/dev/null; }

# An orderly end is a person's Quit, and the window opens again.
end_of_program() {
  local code=0
  wait "$pid" || code=$?
  [ $code -ne 77 ] || { echo "skipped: this system has no Landlock" >&2; exit 77; }
  [ $code -eq 0 ] || complain "the program ended with exit code $code"
  judge_memory
  quits=$((quits + 1))
  start
}

check_health() {
  if has_ended; then end_of_program; return; fi
  kill -0 $watch 2>/dev/null || has_ended || complain "no answer: $(tail -1 "$work/answers")"
}

# At rest without a volume, whose shader programs and caches go with it, what is left is what the program keeps for itself; of
# that, what is its own, without the files of libraries that it has touched.
note_memory() {
  go_home || return 0
  awk -v at=$((SECONDS - born)) '/^Rss(Anon|Shmem)/ { own += $2 } END { if (own) print at, own / 1024 }' \
    "/proc/$pid/status" >>"$memory" 2>/dev/null || true
}

# The mean of the first half of the looks against that of the second. A minute's run says nothing of it.
judge_memory() {
  local verdict
  verdict=$(awk -v settled=$settled_s -v most=$growth_percent '
    $1 >= settled { looks[n++] = $2 }
    END { if (n < 6) { print "good memory: it did not run for long enough to judge it"; exit }
          for (i = 0; i < n; ++i) i < n / 2 ? early += looks[i] : late += looks[i]
          early /= int((n + 1) / 2); late /= int(n / 2); growth = 100 * (late / early - 1)
          printf "%s memory: %.0f MB at first, %.0f MB later, in the mean of %d looks each: %+.1f %%\n",
                 (growth > most ? "BAD" : "good"), early, late, n / 2, growth }' "$memory")
  echo "${verdict#* } (in $((SECONDS - born)) s)" >>"$work/verdicts"
  [[ "$verdict" == good* ]] || complain "$verdict"
}

began=$SECONDS quits=0 acts=0 watch= next_home=$((SECONDS + home_every_s))
: >"$actions"
start
while [ $((SECONDS - began)) -lt "$seconds" ]; do
  act
  acts=$((acts + 1))
  check_health
  [ $SECONDS -lt $next_home ] || { note_memory; next_home=$((SECONDS + home_every_s)); }
done
judge_memory
check_health
[ -z "$screenshot" ] || import -window root "$screenshot"
cat "$work/verdicts" 2>/dev/null || true
echo "slowest: $(tail -1 "$work/answers")"
[ -z "${CREST_MONKEY_LOG:-}" ] || cp "$actions" "$memory" "$work/answers" "$work/stderr" "$CREST_MONKEY_LOG"
echo "PASSED: $acts actions in $((SECONDS - began)) s, seed $seed, quit $quits times"
