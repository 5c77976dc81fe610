#!/bin/sh
# Runs the same controllers in lockstep, as amd64 and as i686 programs, and compares what both recorded, value by value.
#   equal_numbers.sh AMD64_BUILD I686_BUILD
#
# TOLERANCE, in the unit of each column: 1e-6. Both compute in IEEE doubles (SSE), so the order of operations may
# change the last bits only: 1e-15 of a value. A recording has seven digits, hence the 1e-6. What is counted
# (cycles, faults, states, raw counts that became radians) has to be the same; a goal that is one count of a servo
# further, 1.5e-3 rad, is a failure.
set -eu
tolerance=1e-6
here=$(dirname "$(readlink -f "$0")")
amd64=$(readlink -f "$1")
i686=$(readlink -f "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 1: a 32-bit program, 2: a 64-bit one. Wrong arguments must not compare a build with itself.
class() { dd if="$1" bs=1 skip=4 count=1 2>/dev/null | od -An -tu1 | tr -d ' '; }

record() { # BUILD CONTROLLER RECORDING ARGUMENTS...
  build=$1 controller=$2 recording=$3
  shift 3
  "$build/bin/darwinop-run" --robot virtual --record "$recording" "$build/$controller" -- "$@" >"$work/out" 2>&1 || {
    echo "$build/$controller ended badly:"
    cat "$work/out"
    exit 1
  }
}

compare() { # CONTROLLER ARGUMENTS...
  controller=$1
  shift
  [ "$(class "$amd64/$controller") $(class "$i686/$controller")" = "2 1" ] || {
    echo "$controller: not a 64-bit and a 32-bit program in $amd64 and $i686"
    exit 2
  }
  record "$amd64" "$controller" "$work/amd64.csv" "$@"
  record "$i686" "$controller" "$work/i686.csv" "$@"
  awk -v tolerance="$tolerance" -v what="$(basename "$controller")" -f "$here/compare_recordings.awk" \
    "$work/amd64.csv" "$work/i686.csv"
}

compare controllers/01_hello_head/01_hello_head --seconds 60
compare controllers/02_symmetry/02_symmetry --seconds 60
compare bin/test_controller 4000
