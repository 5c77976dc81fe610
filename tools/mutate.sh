#!/usr/bin/env bash
# mutate.sh RESULTS [MOST]: is every row of the safety tables tested? Changes one row at a time (fault table, state machine,
# thresholds) in a checkout of its own, and asks who notices, the cheapest first: compiler, unit tests, model check, tests
# with the virtual robot, property tests, 20 000 cycles of the campaign. Appends to RESULTS a line a mutation: name, tab, who
# caught it, or SURVIVED. Lines that are there are not tried again, so it can be stopped at any time. MOST: so many
# mutations and no more. `mutate.sh --list` prints them. MUTATE_MODEL=0: without the model check.
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

threshold_mutations() {
  cat <<'END'
patience 5 to 2 cycles	core/sensors.hpp	s/(kAnswerPatience = )5/\12/
re-powers 3 to 30	safety/board_watch.hpp	s/(kRepowers = )3/\130/
re-power window 60 to 1 s	safety/board_watch.hpp	s/(kRepowerWindow\{std::chrono::seconds\{)60/\11/
press of a button 250 ms to 25 ms	safety/board_watch.cpp	s/(kPress\{milliseconds\{)250/\125/
battery hysteresis 0.3 V to 0	core/servo_limits.hpp	s/(kBatteryHysteresis = )0.3/\10/
tilt hysteresis 15 deg to 0	safety/board_watch.cpp	s/(kTiltHysteresis = )15/\10/
least gravity 3 to 0 m/s2	safety/board_watch.cpp	s/(kLeastGravity = )3.0/\10.0/
agreement of readings 4.5 to 45 ticks	safety/joint_channel.cpp	s/(kAgreement = )[0-9.]+/\145/
placed writes 2 to 1	safety/joint_channel.hpp	s/(placed_writes_ >= )2/\11/
caught up 0.15 to 15 rad	safety/joint_channel.hpp	s/(kCaughtUp = )0.15/\115/
held up 3 to 300 s	safety/joint_channel.hpp	s/(kHeldUp\{std::chrono::seconds\{)3/\1300/
readings apart 5 to 500 cycles	safety/joint_channel.cpp	s/(kApart = )5/\1500/
rest 1 s to 0	safety/guard_states.cpp	s/(kRest\{std::chrono::seconds\{)1/\10/
round of looks 25 to 1	safety/guard_states.cpp	s/(kLookRound = )kJoints \+ 5/\11/
greatest P gain 254 to 2540	core/servo_limits.hpp	s/254 \* kGain/2540 * kGain/
grace of an overload bit 300 ms to 0	safety/trip_watch.hpp	s/(kGrace\{std::chrono::milliseconds\{)300/\10/
start-up of servos 1 s to 0	safety/servo_watch.hpp	s/(kStartUp\{std::chrono::milliseconds\{)1000/\10/
heat hysteresis 5 to 0	core/servo_limits.hpp	s/(kHeatHysteresis = )5/\10/
END
}

mutations() { fault_mutations && state_mutations && threshold_mutations; }
if [ "${1:-}" = --list ]; then
  mutations
  exit
fi

[ $# -ge 1 ] || { sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
results=$(readlink -f "$1")
most=${2:-1000000}
tree=$PWD/build/mutants
log=$tree/build/mutant.log
touch "$results"
[ -d "$tree" ] || git worktree add --detach "$tree" HEAD >/dev/null
git -C "$tree" checkout -q -- .
git -C "$tree" checkout -q --detach "$(git rev-parse HEAD)"
(cd "$tree" && mkdir -p build && cmake --preset debug -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_C_COMPILER_LAUNCHER=ccache -DDARWINOP_WINDOW=OFF >build/configure.log)
export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1

# Builds a test program and runs it; prints what failed. Fails when nothing did.
caught_by() {
  local program=$1
  ninja -C "$tree/build/debug" --quiet "$program" >"$log" 2>&1 || {
    # Tests name rows in static_assert and constexpr tables also.
    if grep -q 'error' "$log"; then echo compiler && return; else cat "$log" >&2 && exit 1; fi
  }
  ! timeout 900 "$tree/build/debug/bin/$program" "${@:2}" >"$log" 2>&1 || return 1
  printf '%s: %s\n' "$program" "$(grep -oE '^\[  FAILED  \] [A-Za-z0-9_/]+\.[A-Za-z0-9_/]+|judge.*|seed.*' "$log" | head -1 | sed 's/.*\] //')"
}

# Rows that the model has no cause for cannot be noticed by it.
in_the_model() {
  case $1 in
    BatteryLow* | BatteryEmpty* | ServoHot* | ServoOverheat* | ServoVoltage* | ServoSilent* | EncoderStuck* | Fell* | StartMissed*) return 1 ;;
    *ends_controller*) return 1 ;;  # there a controller may go on asking as well as end
    states.hpp* | patience*) return 0 ;;
    *' to '*) return 1 ;;           # thresholds
    *) return 0 ;;
  esac
}

caught_by_model() {
  [ "${MUTATE_MODEL:-1}" != 0 ] && in_the_model "$1" || return 1
  ! (cd "$tree" && tools/model-check.sh build/debug/bin processes) >"$log" 2>&1 || return 1
  echo "model: $(grep -oE 'assertion violated.*|acceptance cycle' "$log" | head -1 | sed 's/ (at depth.*//')"
}

# Prints who notices. The model comes behind the unit tests: it takes longer for what it does not catch.
judge() {
  if ! ninja -C "$tree/build/debug" --quiet print_model_tables >"$log" 2>&1; then
    echo compiler
  else
    caught_by safety_test --gtest_brief=1 || caught_by_model "$1" || caught_by safety_on_board_test --gtest_brief=1 ||
      caught_by servo_hazards_test --gtest_brief=1 || caught_by safety_property_test --gtest_brief=1 ||
      caught_by campaign_deep 20000 1 || echo SURVIVED
  fi
}

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
