#!/bin/sh
# Runs the same controllers in lockstep, as amd64 programs and as those of another computer, and compares what both
# recorded, value by value.
#   equal_numbers.sh AMD64_BUILD OTHER_BUILD
#
# TOLERANCE, in the unit of each column: 1e-6. All compute in IEEE doubles (SSE, VFP) without fused multiply-add, so the
# order of operations and the C library's sines may change the last bits only: 1e-15 of a value. A recording has seven
# digits, hence the 1e-6. What is counted (cycles, faults, states, raw counts that became radians) has to be the same; a
# goal that is one count of a servo further, 1.5e-3 rad, is a failure.
set -eu
tolerance=1e-6
here=$(dirname "$(readlink -f "$0")")
amd64=$(readlink -f "$1")
other=$(readlink -f "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The machine of a program's ELF header. Wrong arguments must not compare a build with itself.
machine() {
  case $(od -An -tu1 -j18 -N2 "$1" | tr -s ' ') in
    ' 62 0') echo amd64 ;;
    ' 3 0') echo i686 ;;
    ' 40 0') echo armhf ;;
    ' 183 0') echo aarch64 ;;
    *) echo "unknown machine" ;;
  esac
}

record() { # BUILD CONTROLLER RECORDING ARGUMENTS...
  build=$1 controller=$2 recording=$3
  shift 3
  rm -f "$recording"  # --record replaces no file
  "$build/bin/darwinop-run" --robot virtual --record "$recording" "$build/$controller" -- "$@" >"$work/out" 2>&1 || {
    echo "$build/$controller ended badly:"
    cat "$work/out"
    exit 1
  }
}

compare() { # CONTROLLER ARGUMENTS...
  controller=$1
  shift
  kind=$(machine "$other/$controller")
  case $(machine "$amd64/$controller")-$kind in
    amd64-i686 | amd64-armhf | amd64-aarch64) ;;
    *) echo "$controller: not for amd64 and another computer in $amd64 and $other" && exit 2 ;;
  esac
  record "$amd64" "$controller" "$work/amd64.csv" "$@"
  record "$other" "$controller" "$work/other.csv" "$@"
  awk -v tolerance="$tolerance" -v what="$(basename "$controller") ($kind)" -f "$here/compare_recordings.awk" \
    "$work/amd64.csv" "$work/other.csv"
}

compare controllers/01_hello_head/01_hello_head --seconds 60
compare controllers/02_symmetry/02_symmetry --seconds 60
compare bin/test_controller 4000
