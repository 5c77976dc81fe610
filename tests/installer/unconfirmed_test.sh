#!/usr/bin/env bash
# A version whose self-test was interrupted: the next boot, and what replaces it.
# shellcheck disable=SC2154  # robot.sh sets what is read here
. "$(dirname "$(readlink -f "$0")")/robot.sh"

scenario_unconfirmed_version_goes_at_the_next_boot() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  hold_an_install "$v2"
  robot_kill_sessions
  rm "$ROBOT/run/hold-self-test"
  robot_boot
  wait "$held" || true
  [ "$booted" = 0.1.0+a ] || fail "after the power cut runs: ${booted:-nothing}"
  expect_version 0.1.0+a
  run_install --bundle "$v2"
  expect_status 0
  expect_boots 0.2.0+b
}

scenario_unconfirmed_first_version_goes_at_the_next_boot() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  hold_an_install "$v1"
  robot_kill_sessions
  rm "$ROBOT/run/hold-self-test"
  robot_boot 25
  wait "$held" || true
  [ -z "$booted" ] || fail "an unconfirmed first version runs after the power cut: $booted"
  run_install --status
  expect_said "$msg_not_confirmed|none"
  run_install --bundle "$v1"
  expect_status 0
  expect_boots 0.1.0+a
}

# An installation of v2 over v1 that died in its self-test, on a robot whose power was then switched off.
leave_v2_untested() {
  hold_an_install "$1"
  robot_kill_sessions
  wait "$held" || true
  rm "$ROBOT/run/hold-self-test"
  [ "$(version_now)" = 0.2.0+b ] || fail "the test did not come to an unconfirmed version"
  : >"$ROBOT/run/fail-self-test"
}

scenario_what_replaces_an_unconfirmed_version_and_fails_does_not_confirm_it() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  leave_v2_untested "$v2"
  run_install --rollback
  expect_status 4
  expect_version 0.1.0+a
  expect_confirmed
  leave_v2_untested "$v2"
  run_install --bundle "$v1"
  expect_status 4
  expect_version 0.1.0+a
  expect_confirmed
  expect_boots 0.1.0+a
}

scenario_what_replaces_an_unconfirmed_version_keeps_the_previous_one() {
  local v0 v1 v2; v0=$(fake_bundle 0.0.1+o); v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v0"
  run_install --bundle "$v1"
  leave_v2_untested "$v2"
  rm "$ROBOT/run/fail-self-test"
  run_install --rollback
  expect_status 0
  expect_version 0.1.0+a
  expect_confirmed
  run_install --status
  expect_said '^previous: *0\.0\.1\+o'
  run_install --rollback
  expect_status 0
  expect_version 0.0.1+o
}

run_scenarios "$@"
