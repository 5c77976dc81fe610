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

line_mutations() {
  cat <<'END'
patience 5 to 2 cycles	core/sensors.hpp	s/(kAnswerPatience = )5/\12/
re-powers 3 to 30	safety/board_watch.hpp	s/(kRepowers = )3/\130/
re-power window 60 to 1 s	safety/board_watch.hpp	s/(kRepowerWindow\{std::chrono::seconds\{)60/\11/
press of a button 250 ms to 25 ms	safety/board_watch.cpp	s/(kPress\{milliseconds\{)250/\125/
battery hysteresis 0.3 V to 0	core/servo_limits.hpp	s/(kBatteryHysteresis = )0.3/\10/
tilt hysteresis 15 deg to 0	safety/board_watch.cpp	s/(kTiltHysteresis = )15/\10/
least gravity 3 to 0 m/s2	safety/board_watch.cpp	s/(kLeastGravity = )3.0/\10.0/
power counts as on after one answer	safety/board_watch.cpp	s/seen.servo_power && !power_off_.on\(\)/seen.servo_power/
power withheld by the newest loss only	safety/board_watch.cpp	s/since_.back\(\) </since_.front() </
agreement of readings 4.5 to 45 ticks	safety/joint_channel.cpp	s/(kAgreement = )[0-9.]+/\145/
readings apart 5 to 500 cycles	safety/joint_channel.cpp	s/(kApart = )5/\1500/
placed outside of its range	safety/joint_channel.cpp	s/range.low.value, range.high.value/range.low.value - 1, range.high.value + 1/
caught up 0.15 to 15 rad	safety/joint_channel.hpp	s/(kCaughtUp = )0.15/\115/
held up 3 to 300 s	safety/joint_channel.hpp	s/(kHeldUp\{std::chrono::seconds\{)3/\1300/
refusals 20 to 2000	safety/joint_guard.hpp	s/(kRefusals = )20/\12000/
written while suspected	safety/joint_guard.hpp	s/if \(suspected_\) return true;/if (suspected_ \&\& uncertain_) return true;/
suspected joint counts as driven	safety/joint_guard.hpp	s/channel_.hasGoal\(\) && !suspected_/channel_.hasGoal()/
moved while uncertain	safety/joint_guard.hpp	s/if \(uncertain_ \|\| !on_seen_/if (!on_seen_/
moved before torque is seen	safety/joint_guard.hpp	s/if \(uncertain_ \|\| !on_seen_/if (uncertain_/
torque on while suspected	safety/joint_guard.hpp	s/ && has_goal_ && !suspected_/ \&\& has_goal_/
torque on without the goal seen	safety/joint_guard.hpp	s/channel_.placed\(\) && has_goal_ &&/channel_.placed() \&\&/
speed limit of the controller counts when safety moves	safety/joint_guard.hpp	s/if \(by_itself\)/if (by_itself \&\& limp_)/
torque seen by any poll	safety/joint_guard.cpp	s/polled && seen.torque_enabled\) on_seen_/polled) on_seen_/
torque seen survives torque on	safety/joint_guard.cpp	s/^  on_seen_ = false;//
never uncertain	safety/joint_guard.cpp	s/^    uncertain_ = true;/    uncertain_ = false;/
certain without a poll	safety/joint_guard.cpp	s/^  else if \(polled\)$/  else/
restart not seen by speed limit 0	safety/joint_guard.cpp	s/seen.speed_limit.value <= 0 \|\| \(off/false || (off/
restart not seen by torque off	safety/joint_guard.cpp	s/\(off && never_on && channel_.moving\(\)\)/(off \&\& never_on \&\& channel_.out())/
placed joint stays when uncertain	safety/joint_guard.cpp	s/restarted \|\| doubtful \|\|/restarted || (doubtful \&\& off) ||/
old reading keeps its goal	safety/joint_guard.cpp	s/seen.motion.age > kAnswerPatience/seen.motion.age > 100 * kAnswerPatience/
late goal of a stalled board stays	safety/joint_guard.cpp	s/(polled && uncertain_ && had_limit_ .*)orderOff\(\)/\1off_due_ = off_due_/
late goal: torque off for any missed answer	safety/joint_guard.cpp	s/polled && uncertain_ && had_limit_ &&/polled \&\& uncertain_ \&\&/
goal in place within 1 to 100 ticks	safety/joint_guard.cpp	s/(kTolerance = )kRadPerTick/\1100 * kRadPerTick/
placed at any speed limit	safety/joint_guard.cpp	s/<= config_.gentle_speed \+ kSpeedTolerance/<= 1000 * kSpeedTolerance/
placed without a speed limit	safety/joint_guard.cpp	s/&& seen.speed_limit.value > 0 &&$/\&\&/
shut off at once: first time is a fact	safety/joint_guard.cpp	s/if \(shut && shut_at_once_\)/if (shut)/
shut off at once: never a fact	safety/joint_guard.cpp	s/if \(shut && shut_at_once_\)/if (shut \&\& !shut)/
shut off at once: torque on	safety/joint_guard.cpp	s/has_goal_ = took && !shut/has_goal_ = took/
cleared suspicion keeps its goal	safety/joint_guard.cpp	s/\(was_suspected && !suspected_\) \|\|/(was_suspected \&\& absent_) ||/
lost servo keeps its goal	safety/joint_guard.cpp	s/ \|\| watch_.lost\(\) \|\| given_up\) restart/) restart/
lost torque off is not repeated	safety/joint_guard.cpp	s/(if \(off_ordered_ .*\)) orderOff\(\)/\1 off_due_ = off_due_/
old polls count after torque off	safety/joint_guard.cpp	s/if \(!off_ordered_\) stiff_ = torque_known_ = false;//
torque off and on does not reset a trip	safety/joint_guard.cpp	s/if \(on && limp_\) resetTrip/if (on \&\& limp_ \&\& absent_) resetTrip/
tripped joint stays engaged	safety/joint_guard.cpp	s/ \|\| limp_ \|\| trip_ != Trip::kNone\)/ || limp_)/
limp joint stays engaged	safety/joint_guard.cpp	s/ \|\| limp_ \|\| trip_ != Trip::kNone\)/ || trip_ != Trip::kNone)/
joint left out is driven	safety/joint_guard.cpp	s/never_driven_\{no_writes_ \|\| config.left_out\[index\(joint\)\]\}/never_driven_{no_writes_}/
joint without writes is only left out	safety/joint_guard.cpp	s/no_writes_\{absent_ \|\| config.no_writes\[index\(joint\)\]\}/no_writes_{absent_}/
absent joint gets writes	safety/joint_guard.cpp	s/no_writes_\{absent_ \|\| config/no_writes_{config/
torque off to a joint without writes	safety/joint_guard.hpp	s/off_due_ = !no_writes_;/off_due_ = true;/
torque off of a joint without writes is repeated	safety/joint_guard.hpp	s/return off_ordered_ \|\| no_writes_;/return off_ordered_;/
push at 0.5 to 0.05 rad/s	safety/joint_guard.cpp	s/(kFastEnough = )0.5/\10.05/
push of a stuck encoder 0.75 to 0.075 N m	safety/encoder_watch.hpp	s/(kPush = )0.75/\10.075/
stuck encoder 500 to 50 ms	safety/encoder_watch.hpp	s/(kLongEnough\{std::chrono::milliseconds\{)500/\150/
stuck encoder when pushed one way	safety/encoder_watch.hpp	s/std::min\(up_, down_\)/std::max(up_, down_)/
one reading confirms	safety/debounce.hpp	s/if \(set_ == 2\)/if (set_ == 1)/
one reading clears	safety/debounce.hpp	s/if \(clear_ == 2\)/if (clear_ == 1)/
rest 1 s to 0	safety/guard_states.cpp	s/(kRest\{std::chrono::seconds\{)1/\10/
round of polls 25 to 1	safety/guard_states.cpp	s/(kPollRound = )kJoints \+ 5/\11/
found limp before all are polled	safety/guard_states.cpp	s/!anyStiff\(\) && \(allKnown\(\) \|\| !board_.powered\(\)\)/!anyStiff()/
kneel broken off when the controller ends	safety/guard_states.cpp	s/!driver_.ended\(\) \|\| state_ == State::kKneeling/!driver_.ended()/
taken over without waiting for the others	safety/guard_states.cpp	s/ranges::all_of\(joints_, settled\) && some\)/ranges::any_of(joints_, settled) \&\& some)/
takeover waits for ever	safety/guard_states.cpp	s/const bool waited = taking_over_for_ >=/const bool waited = taking_over_for_ > 1000 */
new session starts in place	safety/guard.cpp	s/in_place_ = asked.start_where_it_is \|\|/in_place_ = true ||/
requests of a former session count	safety/guard.cpp	s/^  for \(JointGuard\& joint : joints_\) joint.forgetRequests\(\);//
torque on to a board that does not answer	safety/guard.cpp	s/if \(answers\) safe.torque_on_/safe.torque_on_/
goals move on while the board is silent	safety/guard.cpp	s/else if \(answers\)$/else/
hot servos are not slow	safety/guard.cpp	s/by_itself \|\| faults_.slow\(\)/by_itself/
safety's own moves are not slow	safety/guard.cpp	s/by_itself \|\| faults_.slow\(\)/by_itself \&\& faults_.slow()/
uncertain joint is not held	safety/guard.cpp	s/if \(answers\) safe.skipped_ &=/if (!answers) safe.skipped_ \&=/
joints of a pose arrive one by one	safety/guard.cpp	s/if \(!movesByItself\(\)\) return shares;/return shares;/
an old image is a sign of life	safety/driver_watch.hpp	s/asked.sequence > sequence_\)/asked.sequence >= sequence_)/
unattended session resets faults	safety/driver_watch.hpp	s/by_driver && !asked.unattended/by_driver/
end of a session is forgotten	safety/driver_watch.hpp	s/\|\| \(ended_ && !came_\)//
released session goes on	safety/driver_watch.hpp	s/ended_ = ended_ \|\| released_ \|\|/ended_ = ended_ ||/
pose: patience 1.5 to 0.15	safety/pose_move.cpp	s/(kPatience = )1.5/\10.15/
pose: settling 2 to 0.02 s	safety/pose_move.cpp	s/(kSettle = )2.0/\10.02/
start pose: recent 5 to 500 cycles	safety/start_pose.cpp	s/(kRecent = )5/\1500/
start pose: 230 to 460 ticks	safety/start_pose.hpp	s/(kStartPoseTolerance = )230/\1460/
start pose: upright within g/4 to g	safety/start_pose.hpp	s@(kOrientationTolerance = kGravity) / 4@\1@
greatest P gain 254 to 2540	core/servo_limits.hpp	s/254 \* kGain/2540 * kGain/
grace of an overload bit 300 ms to 0	safety/trip_watch.hpp	s/(kGrace\{std::chrono::milliseconds\{)300/\10/
overload bit in the grace raises no suspicion	safety/trip_watch.hpp	s/return early_ \|\| bits_/return bits_/
torque limit 0 not a shutdown	safety/trip_watch.hpp	s/!seen.torque_enabled \|\| limit_zero_/!seen.torque_enabled/
torque off not a shutdown	safety/trip_watch.hpp	s/!seen.torque_enabled \|\| limit_zero_/limit_zero_/
start-up of servos 1 s to 0	safety/servo_watch.hpp	s/(kStartUp\{std::chrono::milliseconds\{)1000/\10/
heat hysteresis 5 to 0	core/servo_limits.hpp	s/(kHeatHysteresis = )5/\10/
bad voltage after 100 to 0 ms	safety/servo_watch.hpp	s/(kVoltageOn\{std::chrono::milliseconds\{)100/\10/
bad voltage for 1000 to 0 ms	safety/servo_watch.hpp	s/(kVoltageOff\{std::chrono::milliseconds\{)1000/\10/
END
}

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
