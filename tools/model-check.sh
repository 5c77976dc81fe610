#!/usr/bin/env bash
# model-check.sh BIN [deep]: checks tests/model/robot.pml with spin against the tables that BIN/print_model_tables prints.
# Every state is visited; the figures go to stdout. `deep`: with the widest faults, for an hour or so.
set -euo pipefail
bin=$(cd "$1" && pwd)
effort=${2:-gate}
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
folder=build/model
compiler=${CC:-gcc}

# check NAME DEFINES...: one configuration, exhaustively.
check() {
  local name=$1 place=$folder/$1
  shift
  rm -rf "$place"
  mkdir -p "$place"
  "$bin/print_model_tables" >"$place/tables.pml"
  cp tests/model/robot.pml "$place/"
  (
    cd "$place"
    spin "$@" -a robot.pml >spin.log || { cat spin.log && exit 1; }
    "$compiler" -O2 -DSAFETY -DNOREDUCE -DCOLLAPSE -DVECTORSZ=1024 -DMEMLIM=8000 -o pan pan.c
    ./pan -m20000000 -w24 >pan.log 2>&1 || { cat pan.log && exit 1; }
    if ! grep -q 'errors: 0' pan.log || grep -q 'max search depth too small' pan.log; then
      grep -E 'assertion violated|errors:|depth' pan.log
      [ ! -e robot.pml.trail ] || ./pan -r 2>&1 | grep -E '^[0-9]+ came' | tail -40
      echo "model: $name is violated; above: the last cycles before" >&2
      exit 1
    fi
    printf 'model: %s: %s states, %s transitions, no violation\n' "$name" \
      "$(sed -n 's/^ *\([0-9.e+]*\) states, stored.*/\1/p' pan.log)" \
      "$(sed -n 's/^ *\([0-9.e+]*\) transitions.*/\1/p' pan.log)"
  )
}

# People, processes and servos on a good wire; then a bad wire, outages of up to 6 cycles, and nobody but a controller.
check processes -DNO_WIRE
check wire -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=6
[ "$effort" != deep ] || check everything -DMAXMISS=7
