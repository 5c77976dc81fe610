#!/usr/bin/env bash
# mutate.sh RESULTS [MOST]: is every row of the safety tables tested? Changes one line at a time (fault table, state machine,
# thresholds and conditions) in a checkout of its own, and records which check detects it, the cheapest first: compiler, unit
# tests, property tests, tests with the virtual robot, 20 000 cycles of the campaign, model check. Appends to RESULTS a line a
# mutation: name, tab, what detected it, or SURVIVED. Lines that are there are not tried again, so it can be stopped at any
# time. MOST: so many mutations and no more. `mutate.sh --list` prints them, and fails when a pattern does not match exactly
# one line: `./dev test scripts` runs it. MUTATE_MODEL=0: without the model check.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

faults=core/faults.hpp
states=safety/states.hpp

# Each mutation: name, file, sed expression; separated by tabs.
fault_mutations() {
  local number text fault reaction latched ends other
  while IFS=: read -r number text; do
    read -r fault reaction latched ends < <(sed -E 's/.*Fault::k(\w+), Reaction::k(\w+), (\w+), (\w+),.*/\1 \2 \3 \4/' <<<"$text")
    case $reaction in
      Report) other=Limp ;;
      Slow | Hold | StopSending) other=Report ;;
      Kneel) other=Hold ;;
      *) other=Kneel ;;
    esac
    printf '%s reaction %s for %s\t%s\t%ss/Reaction::k%s,/Reaction::k%s,/\n' "$fault" "$other" "$reaction" $faults "$number" "$reaction" "$other"
    printf '%s latched not %s\t%s\t%ss/(Reaction::k\\w+), %s,/\\1, %s,/\n' "$fault" "$latched" $faults "$number" "$latched" "$(inverse "$latched")"
    printf '%s ends_controller not %s\t%s\t%ss/(Reaction::k\\w+, \\w+), %s,/\\1, %s,/\n' "$fault" "$ends" $faults "$number" "$ends" "$(inverse "$ends")"
  done < <(grep -nE '^ +\{Fault::k\w+, Reaction::k\w+, (true|false), (true|false),' $faults)
}
inverse() { if [ "$1" = true ]; then echo false; else echo true; fi; }

state_mutations() {
  local number text target
  while IFS=: read -r number text; do
    target=$(sed -nE 's/.*(return|\?) State::k(\w+).*/\2/p' <<<"$text")
    [ -n "$target" ] || continue
    printf 'states.hpp:%s stays instead of %s\t%s\t%ss/(return|\\?) State::k%s/\\1 state/\n' "$number" "$target" $states "$number" "$target"
    [ "$target" = Driven ] || printf 'states.hpp:%s Driven instead of %s\t%s\t%ss/(return|\\?) State::k%s/\\1 State::kDriven/\n' "$number" "$target" $states "$number" "$target"
  done < <(grep -nE 'return .*State::k' $states)
}

line_mutations() { grep -v '^#' tools/mutations.tsv; }

mutations() { line_mutations && state_mutations && fault_mutations; }
if [ "${1:-}" = --list ]; then
  wrong=0
  while IFS=$'\t' read -r name file change; do
    printf '%s\t%s\t%s\n' "$name" "$file" "$change"
    [ "$(sed -E "$change" "$file" | diff - "$file" | grep -c '^>')" = 1 ] || { echo "mutate: $name: not one line of $file" >&2 && wrong=1; }
  done < <(mutations)
  exit $wrong
fi

[ $# -ge 1 ] || { sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
results=$(readlink -f "$1")
most=${2:-1000000}
tree=$PWD/build/mutants
log=$tree/build/mutant.log
touch "$results"
[ -d "$tree" ] || git worktree add --detach "$tree" HEAD >/dev/null
git -C "$tree" checkout -q -- .
git -C "$tree" checkout -q --detach "$(git rev-parse HEAD)"
# A header of core is included everywhere: one batch a room and no debug information, so that a mutation compiles in seconds.
(cd "$tree" && mkdir -p build && cmake --preset debug -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
  -DCMAKE_CXX_FLAGS_DEBUG=-O1 '-DDARWINOP_COMPUTE_OPTIONS=-O1;-g0' -DDARWINOP_TEST_OPTIONS=-O0 -DCMAKE_UNITY_BUILD_BATCH_SIZE=100 \
  '-DDARWINOP_TEST_FOLDERS=safety;campaign;model' >build/configure.log)
export GTEST_FAIL_FAST=1 GTEST_BRIEF=1 DARWINOP_SEED=2026 RC_PARAMS=seed=2026
export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros

compiler_says() { printf 'compiler: %s\n' "$(grep -oE 'error: .*' "$log" | head -1 | cut -c8-100)"; }

# Builds a test program and runs it; prints what failed. Fails when nothing did.
caught_by() {
  local program=$1
  ninja -C "$tree/build/debug" --quiet "$program" >"$log" 2>&1 || {
    # Tests name rows in static_assert and constexpr tables as well.
    if grep -q 'error' "$log"; then compiler_says && return; else cat "$log" >&2 && exit 1; fi
  }
  ! timeout 900 "$tree/build/debug/bin/$program" "${@:2}" >"$log" 2>&1 || return 1
  printf '%s: %s\n' "$program" "$(grep -oE '^\[  FAILED  \] [A-Za-z0-9_/]+\.[A-Za-z0-9_/]+|^result: .*' "$log" | head -1 | sed -E 's/.*\] |result: //')"
}

# Rows that the model has no cause for cannot be noticed by it.
in_the_model() {
  case $1 in
    *ends_controller*) return 1 ;;  # there a controller may go on asking as well as end
    states.hpp* | patience* | *' reaction '* | *' latched '*) return 0 ;;
    *) return 1 ;;
  esac
}

caught_by_model() {
  [ "${MUTATE_MODEL:-1}" != 0 ] && in_the_model "$1" || return 1
  ! (cd "$tree" && tools/model-check.sh build/debug/bin charge && tools/model-check.sh build/debug/bin processes) >"$log" 2>&1 || return 1
  echo "model: $(grep -oE 'assertion violated.*|acceptance cycle' "$log" | head -1 | sed 's/ (at depth.*//')"
}

# Prints what detects it. The model comes last: it takes longest.
judge() {
  if ! ninja -C "$tree/build/debug" --quiet print_model_tables >"$log" 2>&1; then
    compiler_says
  else
    caught_by safety_test || caught_by safety_property_test || caught_by safety_on_board_test || caught_by servo_hazards_test ||
      caught_by campaign_deep 20000 1 || caught_by_model "$1" || echo SURVIVED
  fi
}

# Else a broken build would count as a mutation that the compiler detects.
ninja -C "$tree/build/debug" --quiet print_model_tables safety_test safety_property_test safety_on_board_test servo_hazards_test \
  campaign_deep >"$log" 2>&1 || { cat "$log" >&2 && exit 1; }
while IFS=$'\t' read -r name file change; do
  ! cut -f1 "$results" | grep -qxF -- "$name" || continue
  [ "$most" -gt 0 ] || break
  most=$((most - 1))
  sed -E -i "$change" "$tree/$file"
  if git -C "$tree" diff --quiet; then
    printf '%s\t%s\n' "$name" "NOT APPLIED: its pattern is not in $file" >>"$results"
  else
    printf '%s\t%s\n' "$name" "$(judge "$name")" >>"$results"
  fi
  git -C "$tree" checkout -q -- .
  tail -1 "$results"
done < <(mutations)
echo "mutations: $(wc -l <"$results"), caught: $(grep -cvE 'SURVIVED|NOT APPLIED' "$results"), survived: $(grep -c SURVIVED "$results")"
