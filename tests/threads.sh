#!/usr/bin/env bash
# threads.sh FOLDER: builds what the studio does in threads of its own under ThreadSanitizer, and runs its tests.
# The program stays on one processor: TBB, which is not instrumented, then runs its loops in the thread that calls them, and
# says nothing false. Races between the parts of such a loop are not looked for. A race is found by what orders two accesses,
# not by their coming together, so that one processor is enough. Tests that draw are left out: the driver is not instrumented.
set -eu
folder=$1 source=$(cd "$(dirname "$0")/.." && pwd)
[ -f "$folder/build.ninja" ] || cmake -S "$source" -B "$folder" -G Ninja -DCREST_SANITIZE=thread -DCMAKE_BUILD_TYPE=None
ninja -C "$folder" test_threads
# Its shadow memory has fixed places, which the kernel's random ones may take
TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1 setarch -R taskset -c "$(taskset -pc $$ | grep -o '[0-9]*$')" \
  "$folder/tests/test_threads" --gtest_brief=1 --gtest_filter='-*Offscreen*:Store.*'
