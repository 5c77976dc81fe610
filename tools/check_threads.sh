#!/usr/bin/env bash
# check_threads.sh: which tests run the threads of each room under the thread sanitizer? Every folder whose sources start
# a thread has a row below: a folder of tests/ that preset tsan builds (DARWINOP_TEST_FOLDERS), or the reason why none.
# Stage scripts of ./dev test runs it. Prints each folder without a row and each row without need.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

# room | folder of its tests, or - | why there
rows='
apps | - | programs: whole processes, as their users start them
connect | hal/keyboard_terminal | keys, in a real terminal
gap/benchmark/run | - | MPI and Ceres are not built for the sanitizer, which reports errors that they do not have
gap/parallel | gap/parallel |
hal/audio/program | hal/audio | speech; the player needs a sound card
hal/camera_v4l2 | hal/camera_v4l2 |
hal/cm730 | hal/cm730 |
hal/cm730/diagnosis | hal/cm730 | of all parts of the room
hil-mocks | hil-mocks |
hil-mocks/camera/shim | hal/camera_v4l2 | linked in front of the camera
remote/jpeg | remote/jpeg |
runtime | runtime |
supervisor | supervisor |
window/drive | window |
window/live | window/live |
'

starting=$(git grep -lE '\bstd::(jthread|thread) *(\{|[a-z_]+[;{(=])|\bstd::vector<std::j?thread>|\bstd::async\(|\bpthread_create\(' -- \
  '*.cpp' '*.hpp' ':!tests/' ':!tools/' ':!controllers/' | sed 's:/[^/]*$::' | sort -u)
built=$(sed -n 's/.*"DARWINOP_TEST_FOLDERS": "\(.*\)".*/\1/p' CMakePresets.json)
named=$(sed -n 's:^\([a-z0-9/_-]*\) |.*:\1:p' <<<"$rows" | sort)
violations=$(
  while IFS='|' read -r room tests why; do
    room=${room// /} tests=${tests// /} why=${why# }
    if [ "$tests" = - ]; then
      [ -n "$why" ] || echo "$room: no tests under the thread sanitizer, and no reason"
    elif [[ ";$built;" != *";$tests;"* ]]; then
      echo "$room: preset tsan does not build tests/$tests"
    fi
  done < <(sed '/^$/d' <<<"$rows")
  comm -23 <(echo "$starting") <(echo "$named") | sed 's|$|: starts a thread; add a row to tools/check_threads.sh|'
  comm -13 <(echo "$starting") <(echo "$named") | sed 's|$|: starts no thread|'
)
[ -z "$violations" ] || { printf '%s\n' "$violations" && exit 1; }
echo "rooms that start threads: $(wc -l <<<"$starting"); under the thread sanitizer: tests of ${built//;/, }"
