#!/usr/bin/env bash
# --stop, on a robot with a runtime of shell scripts.
# shellcheck disable=SC2154  # controller_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/controller_lab.sh"

scenario_stop_ends_a_controller_that_another_terminal_runs() {
  controller walker "$until_stopped"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_for "$LAB/stdout" '^walking$'
  run_install --stop
  expect_status 0
  expect_said 'walker stopped'
  wait_install
  expect_status 7
  grep -q '^done$' "$LAB/stdout" || fail "it did not end normally"
  run_install --stop
  expect_status 0
}

# fake_driver PID: what the runtime reports while that process exists, or always if it never did.
fake_driver() {
  sed -i "2i { [ ! -d /proc/$1 ] && [ $1 -lt 99999 ]; } || echo 'driver    pid $1, for 3 s'" "$ROBOT/opt/darwinop/current/bin/darwinop-runtime"
}

scenario_stop_ends_a_program_that_was_started_on_the_robot_itself() {
  start_runtime
  env --default-signal=INT sleep 300 &
  local driver=$!
  fake_driver "$driver"
  run_install --stop
  expect_status 0
  expect_said "sleep $msg_other_stopped"
  ! kill -0 "$driver" 2>/dev/null || fail "it goes on"
}

scenario_stop_ends_a_program_that_drives_without_a_runtime() {
  printf '[Robot]\nport = /tmp/port\n' >"$ROBOT/opt/darwinop/robot.ini"
  : >"$ROBOT/tmp/port"
  sed -i '2i case $* in *--status*) exit 1 ;; esac' "$ROBOT/opt/darwinop/current/bin/darwinop-runtime"
  env --default-signal=INT sleep 300 3<"$ROBOT/tmp/port" &
  local driver=$!
  run_install --stop
  expect_status 0
  expect_said "sleep $msg_other_stopped"
  ! kill -0 "$driver" 2>/dev/null || fail "it goes on"
}

# It brings the robot to rest.
scenario_stop_leaves_the_runtime_its_port() {
  printf '[Robot]\nport = /tmp/port\n' >"$ROBOT/opt/darwinop/robot.ini"
  : >"$ROBOT/tmp/port"
  sed -i '2i case $* in *--status*) exit 1 ;; esac' "$ROBOT/opt/darwinop/current/bin/darwinop-runtime"
  cp /bin/sleep "$LAB/darwinop-runtime"
  "$LAB/darwinop-runtime" 300 3<"$ROBOT/tmp/port" &
  local runtime=$!
  run_install --stop
  expect_status 0
  kill -0 "$runtime" 2>/dev/null || fail "it was ended"
}

scenario_stop_fails_if_something_still_drives() {
  fake_driver 99999
  run_install --stop
  expect_status 1
  expect_said "\(process 99999\) $msg_still_drives"
}

# A disk that is full at that moment.
scenario_a_controller_that_stop_would_not_find_does_not_run() {
  controller walker "$until_stopped"
  rm "$ROBOT/bin/mv"
  cat >"$ROBOT/bin/mv" <<'END'
#!/bin/sh
case $* in */running) grep -q '^none$' "$2" || exit 1 ;; esac
exec /.host/bin/mv "$@"
END
  chmod 755 "$ROBOT/bin/mv"
  start_install --controller "$LAB/pc/walker" --run "$login@$ADDRESS"
  wait_install 30
  expect_status 1
  robot_quiet
}

run_scenarios "$@"
