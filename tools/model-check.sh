#!/usr/bin/env bash
# model-check.sh BIN [deep | CONFIGURATION]: checks tests/model/robot.pml with spin against the tables that
# BIN/print_model_tables prints. Every state is visited; two configurations at a time. The figures go to stdout:
# configuration, states, transitions, depth, MB, seconds. `deep`: all of them, with the widest faults.
set -euo pipefail
bin=$(cd "$1" && pwd)
effort=${2:-gate}
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
folder=build/model
compiler=${CC:-gcc}

# Name, effort, and what the configuration defines. `processes`: people, processes and servos on a good wire. `wire`: lost
# writes and outages of up to MAXMISS cycles, a controller only. `way_out`, `release`: from every state of `processes` the
# robot drives again, or becomes limp, when nothing breaks any more and a person acts (docs/faults.md); they visit what
# `processes` visits, and check the same assertions. `charge`: charge, heat, encoder and falls change in any cycle; they
# double the transitions, so the others go without. `fall`: with [Safety] on_fall = limp. `alone`: servos without a board.
configurations() {
  cat <<'END'
processes deep -DNO_WIRE
wire gate -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=6 -DMAXBOOT=1
way_out gate -DNO_WIRE -DWAY_OUT=1
charge gate -DCHARGE -DNO_WIRE -DFIXED_PROCESSES -DNO_PEOPLE
way_out_charge deep -DCHARGE -DNO_WIRE -DWAY_OUT=1
wire_charge deep -DCHARGE -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=6 -DMAXBOOT=1
release deep -DNO_WIRE -DWAY_OUT=2
processes_hold deep -DNO_WIRE -DON_EXIT=RE_hold
processes_limp deep -DNO_WIRE -DON_EXIT=RE_limp
way_out_hold deep -DNO_WIRE -DWAY_OUT=1 -DON_EXIT=RE_hold
way_out_limp deep -DNO_WIRE -DWAY_OUT=1 -DON_EXIT=RE_limp
fall deep -DCHARGE -DNO_WIRE -DFIXED_PROCESSES -DWAY_OUT=1 -DON_FALL=RE_limp
wire_boot deep -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=7
wire_way_out deep -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=7 -DMAXBOOT=1 -DWAY_OUT=1
people_wire deep -DFIXED_PROCESSES -DMAXMISS=6 -DMAXBOOT=1
everything deep -DMAXMISS=7
alone gate -DNO_BOARD -DNO_WIRE -DFIXED_PROCESSES -DNO_PEOPLE
alone_people deep -DNO_BOARD -DNO_WIRE -DFIXED_PROCESSES
alone_processes deep -DNO_BOARD -DNO_WIRE
alone_wire deep -DNO_BOARD -DFIXED_PROCESSES -DNO_PEOPLE -DMAXMISS=6 -DMAXBOOT=1
alone_way_out deep -DNO_BOARD -DNO_WIRE -DWAY_OUT=1
alone_release deep -DNO_BOARD -DNO_WIRE -DWAY_OUT=2
END
}

# One configuration, exhaustively.
check() {
  local name=$1 place=$folder/$1 search=(-DSAFETY) run=()
  shift
  rm -rf "$place"
  mkdir -p "$place"
  "$bin/print_model_tables" >"$place/tables.pml"
  cp tests/model/*.pml "$place/"
  [[ "$*" != *WAY_OUT* ]] || { search=() run=(-a); }  # looks for cycles
  (
    cd "$place"
    spin "$@" -a robot.pml >spin.log 2>&1 || { cat spin.log && exit 1; }
    "$compiler" -O2 "${search[@]}" -DNOREDUCE -DVECTORSZ=1024 -DMEMLIM=12000 -o pan pan.c
    ./pan "${run[@]}" -m10000000 -w24 >pan.log 2>&1 || { cat pan.log && exit 1; }
    if ! grep -q 'errors: 0' pan.log || grep -qE 'max search depth too small|Search not completed' pan.log; then
      [ ! -e robot.pml.trail ] || ./pan -r 2>&1 | grep -E '^[0-9]+ came' | tail -40
      grep -E 'violated|acceptance cycle|errors:|max search depth|out of memory' pan.log || :
      echo "model: $name is violated; above: the last cycles before" >&2
      exit 1
    fi
    figure() { sed -nE "$1" pan.log | head -1; }
    printf '| %s | %s | %s | %s | %s | %s |\n' "$name" "$(figure 's/^ *([0-9.e+]+) states, stored.*/\1/p')" \
      "$(figure 's/^ *([0-9.e+]+) transitions.*/\1/p')" "$(figure 's/.*depth reached ([0-9]+),.*/\1/p')" \
      "$(figure 's/^ *([0-9.]+)\s+total actual memory.*/\1/p')" "$(figure 's/.*elapsed time ([0-9.]+) seconds.*/\1/p')"
  )
}

chosen() {
  case $effort in
    gate) configurations | grep ' gate ' ;;
    deep) configurations ;;
    *) configurations | grep "^$effort " || { echo "model: no configuration $effort" >&2 && exit 2; } ;;
  esac
}

if [ "${MODEL_CONFIGURATION:-}" != "" ]; then  # one of the two at a time
  read -ra words <<<"$MODEL_CONFIGURATION"
  check "${words[0]}" "${words[@]:2}"
  exit
fi
echo '| configuration | states | transitions | depth | MB | s |'
chosen | MODEL_CONFIGURATION='' xargs -P "$(nproc)" -I LINE env MODEL_CONFIGURATION=LINE "$0" "$bin" "$effort"
