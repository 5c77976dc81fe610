#!/usr/bin/env bash
# A real controller, built against the robot's library, on the real i686 runtime with a virtual robot behind the device.
# shellcheck disable=SC2154  # controller_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/controller_lab.sh"

# The programs and the library of ./dev build --robot; DARWINOP_ROBOT_BUILD names another place.
robot_build=${DARWINOP_ROBOT_BUILD:-$SOURCE/build/robot}

put_real_runtime() {
  local home=$ROBOT/opt/darwinop
  [ -x "$robot_build/bundle/bin/darwinop-supervisor" ] || fail "no runtime in $robot_build/bundle; run: ./dev build --robot"
  export DARWINOP_ROBOT_SDK=$robot_build/sdk
  rm -rf "$home"
  mkdir -p "$home/versions"
  cp -r "$robot_build/bundle" "$home/versions/real"
  ln -s versions/real "$home/current"
  install -m 755 "$SOURCE/installer/start" "$home/start"
  mkdir -p "$home/log"
}

state() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-supervisor --status; }

scenario_hello_head_runs_until_ctrl_c_and_as_default() {
  put_real_runtime
  plug_virtual_robot
  cp -r "$SOURCE/controllers/01_hello_head" "$LAB/pc/hello"
  start_install --controller "$LAB/pc/hello" --run "$login@$ADDRESS" -- --seconds 60
  wait_for "$LAB/stdout" 's  neck [+-]0\.[1-9]' 40
  kill -INT -- "-$install_pid"
  wait_install 40
  expect_status 0
  run_install --controller "$LAB/pc/hello" --make-default
  expect_status 0
  wait_for "$ROBOT/opt/darwinop/log/controller.log" 's  neck [+-]0\.[1-9]' 60
  run_install --stop
  expect_status 0
  state | grep -q '^controller .*does not run' || fail "the default controller still runs: $(state)"
  run_install --logs
  expect_said 's  neck [+-]0\.[1-9]'
}

run_scenarios "$@"
