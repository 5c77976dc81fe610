#!/usr/bin/env bash
# What a program that drives the installer reads: steps on file descriptor 3, errors marked, the key of an unknown robot.
# shellcheck disable=SC2154  # robot.sh sets what is read here
. "$(dirname "$(readlink -f "$0")")/robot.sh"

# watch_install ARGS...: as run_install, by somebody who reads $LAB/progress.
watch_install() { run_install --progress "$@" 3>"$LAB/progress"; }

expect_progress() { grep -qxE -- "$1" "$LAB/progress" || fail "no '$1' in: $(cat "$LAB/progress")"; }

scenario_steps_and_how_much_has_come() {
  local v1; v1=$(fake_bundle 0.1.0+a 300)
  watch_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  grep -q '^progress ' "$LAB/progress" || fail "nothing was written to file descriptor 3"
  [ "$(cut -d ' ' -f 2 "$LAB/progress" | uniq | tr '\n' ' ')" = "1 2 3 4 5 " ] || fail "steps: $(cat "$LAB/progress")"
  expect_progress 'progress 2 5 - connecting to darwin@127\.0\.0\.1'
  expect_progress 'progress 4 5 - sending [0-9]+ kB'
  expect_progress 'progress 4 5 0\.[0-9]{3} sending [0-9]+ kB'
  expect_progress 'progress 4 5 1\.000 sending [0-9]+ kB'
  expect_progress 'progress 5 5 - switching over on the robot'
  expect_not_said '^progress'
}

scenario_errors_are_marked_for_programs_only() {
  run_install --rollback
  expect_status 1
  expect_said '^robot: nothing is installed'
  watch_install --rollback
  expect_status 1
  expect_said '^robot: error: nothing is installed'
  stop_sshd
  watch_install --status
  expect_said "^darwinop install: error: .*$msg_refuses"
  run_install --status --progress 3>&-
  expect_status 2
  expect_said "$msg_no_descriptor 3"
}

scenario_an_unknown_key_is_shown_and_that_key_alone_taken() {
  local key wrong=SHA256:AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
  key=$(ssh-keygen -lf "$ROBOT/etc/ssh/ssh_host_ed25519_key.pub" | cut -d ' ' -f 2)
  forget_host_key
  watch_install --status
  expect_status 1
  expect_said "$msg_unknown_host \(ED25519 key ${key//+/\\+}\)"
  expect_progress "host-key ${key//+/\\+}"
  watch_install --host-key "$wrong" --status
  expect_status 1
  expect_said "$msg_has_other_key"
  watch_install --host-key "${key%?}" --status
  expect_status 2
  [ ! -s "$(known_hosts)" ] || fail "the unknown key was stored"
  watch_install --host-key "$key" --status
  expect_status 0
  grep -q ed25519 "$(known_hosts)" || fail "the key was not stored"
}

run_scenarios "$@"
