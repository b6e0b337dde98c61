#!/usr/bin/env bash
# check_bundle.sh FOLDER: the bundle runs in an empty folder, with an empty environment and nowhere to write but there,
# and finds all tests passed.
set -euo pipefail
bundle=$(cd "$1" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
env -i TMPDIR="$folder" HOME=/nonexistent sh "$bundle/run.sh" --quick --minutes 20
grep -q '"all_passed": true' result.json
leftover=$(ls -A)
[ "$leftover" = result.json ] || { echo "left behind: $leftover" >&2; exit 1; }
