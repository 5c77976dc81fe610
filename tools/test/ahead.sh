#!/usr/bin/env bash
# ahead.sh PID STAGE...: the process in the background of run.sh, PID. Builds for the stages, then runs those of $BESIDE.
#
# In a session of its own: Linux shares processors among sessions first (sched_autogroup), and in that of the tests what is
# idle would run before daemons of tests, which have sessions of their own.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh
. tools/test/background.sh

trap 'rm -rf build/ahead' EXIT
runner=$1
shift
DARWINOP_AHEAD=$$  # not for the stages: they stop nothing
ahead_at --idle
# What users build needs no test packages: it can begin while they are installed.
[ ! -e build/ahead/release-tests ] || build release || :
while [ -e build/ahead/packages ]; do sleep 0.2; done
for stage in "$@"; do
  preset=$(builds_of "$stage")
  [ -f "build/ahead/${preset%% *}" ] || continue  # nothing to build, or built for an earlier stage
  kill -0 "$runner" || exit                       # run.sh itself has ended
  # shellcheck disable=SC2086  # words
  build $preset || :  # the stage that needs it tries once more and shows why
  rm -f "build/ahead/${preset%% *}"
done
write_row builds '' ''
for stage in $BESIDE; do
  kill -0 "$runner" || exit
  run_stage "$stage" "in the background" >"build/$stage.log" 2>&1 || :
done
