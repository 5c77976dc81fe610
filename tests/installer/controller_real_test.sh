#!/usr/bin/env bash
# A real controller, built against the robot's library, on the real i686 runtime with a virtual robot behind the device.
# shellcheck disable=SC2154  # controller_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/controller_lab.sh"
# shellcheck source=real_runtime.sh
. "$HERE/real_runtime.sh"

scenario_hello_head_runs_until_ctrl_c_and_as_default() {
  put_real_runtime
  export DARWINOP_ROBOT_SDK=$robot_build/sdk
  plug_virtual_robot
  cp -r "$SOURCE/controllers/01_hello_head" "$LAB/pc/hello"
  start_install --controller "$LAB/pc/hello" --run "$login@$ADDRESS" -- --seconds 60
  wait_for "$LAB/stdout" 's  neck [+-]0\.[1-9]' 40
  expect_user 998 '^[^ ]*darwinop-run '
  expect_user 998 '^[^ ]*controllers/hello/hello '
  expect_user 0 '^[^ ]*darwinop-(runtime|supervisor) '
  kill -INT -- "-$install_pid"
  wait_install 40
  expect_status 0
  run_install --controller "$LAB/pc/hello" --make-default
  expect_status 0
  wait_for "$ROBOT/opt/darwinop/log/controller.log" 's  neck [+-]0\.[1-9]' 60
  expect_user 998 '^[^ ]*/hello/hello '
  run_install --stop
  expect_status 0
  ! supervisor_says | grep '^controller .*pid' || fail "the default controller still runs: $(supervisor_says)"
  run_install --logs
  expect_said 's  neck [+-]0\.[1-9]'
}

run_scenarios "$@"
