#!/usr/bin/env bash
# darwinop run --robot tcp://USER@HOST: a controller on this PC drives a real runtime on the robot, through a real sshd.
# shellcheck disable=SC2154  # remote_lab.sh and robot.sh set what is read here
. "$(dirname "$(readlink -f "$0")")/remote_lab.sh"

scenario_a_whole_run() {
  robot_with_a_runtime
  start_run --picture 160x120
  await '^driving$'
  expect_said 'connected to darwin@127.0.0.1 \([0-9.]+ s\)$'
  expect_said 'version [^ ]+ '
  expect_said "$msg_pose_ok"
  expect_said "$msg_ready \([0-9.]+ s\)$"
  grep -qa -e '--port.0.2.2' "/proc/$(pgrep -x darwinop-remote)/cmdline" || fail "the picture size was not passed on"
  expect_user 998 '^[^ ]*darwinop-remote '
  supervisor_says | grep -q '^driver .*darwinop-remote' || fail "the supervisor does not report the driver: $(supervisor_says)"
  ! tr '\0' '\n' <"/proc/$(pgrep -of '^bash .*/remote_client')/environ" | grep -q DARWINOP_PASSWORD || fail "the password is in the controller's environment"
  # Only on loopback, on both sides.
  ! ss -Hltn 2>/dev/null | awk '{ print $4 }' | grep -vE '^(127\.0\.0\.1|\[::1\]):' || fail "a port is open to the network"
  cp "$LAB/out" "$LAB/first"
  run_install --status
  expect_said "^running: .*$msg_remote_control .*@darwin"
  if DARWINOP_PASSWORD=$password "$run" --robot "tcp://$login@$ADDRESS" "$client" </dev/null >"$LAB/out" 2>&1; then fail "two programs drive"; fi
  expect_said "$msg_remote_control .*@darwin $msg_already_running"
  cp "$LAB/first" "$LAB/out"
  kill -INT -- "-$run_pid"
  wait_run
  expect_status 7
  expect_said '^kneeling$'
  expect_limp
}

# An unmodified example with the library's client.
scenario_an_example_drives_from_here() {
  local hello=${DARWINOP_BIN:-$SOURCE/build/debug/bin}/../controllers/01_hello_head/01_hello_head
  [ -x "$hello" ] || fail "there is no $hello; run: ./dev build"
  robot_with_a_runtime
  client=$hello
  start_run
  await 's  neck [+-]0\.[1-9]'
  kill -INT -- "-$run_pid"
  wait_run
  expect_status 0
  expect_limp
}

scenario_the_start_pose_is_asked_about() {
  robot_with_a_runtime
  make_pose_a_matter_of_a_file
  start_run
  wait_run
  expect_status 3
  expect_said 'KneeR is 0.8 rad off'
  expect_said "$msg_sit_down"
  on_terminal '\[c\]ancel=c\n' --
  expect_status 3
  expect_said "$msg_cancelled"
  on_terminal '\[c\]ancel=\003' --
  expect_status 130
  expect_limp
  on_terminal '\[c\]ancel=g\n' '^driving=\003' --
  expect_status 7
  expect_said "$msg_pose_wrong"
  expect_limp
  # The robot is put into its start pose before the next check.
  : >"$LAB/out"
  (until grep -q 'ancel?' "$LAB/out"; do sleep 0.02; done; rm "$ROBOT/run/pose-unsafe") &
  on_terminal '\[c\]ancel=r\n' '^driving=\003' --
  expect_status 7
  expect_said "$msg_pose_ok"
}

# In every phase, on the PC or on the robot: the robot sits, everything ends, and a message is printed.
scenario_ctrl_c_at_any_moment() {
  local round delay seed=${DARWINOP_SEED:-2026}
  echo "DARWINOP_SEED=$seed"
  robot_with_a_runtime
  for round in 1 2 3; do
    delay=$(((seed * 7 + round * 701) % 2000))
    start_run
    sleep "$((delay / 1000)).$(printf %03d $((delay % 1000)))"
    kill -INT -- "-$run_pid"
    [ $round != 2 ] || kill -INT -- "-$run_pid"
    wait_run
    case $status in
      7 | 143) expect_said '^driving$' ;;
      130) ;;
      *) fail "round $round, Ctrl-C after $delay ms: status $status" ;;
    esac
    expect_said "$msg_limp|$msg_interrupted|$msg_no_runtime"
    ! runtime_says >"$LAB/state" 2>&1 || grep -q '^state .*limp' "$LAB/state" || fail "after $delay ms: $(cat "$LAB/state")"
  done
}

scenario_killed_hung_up_or_crashed_the_robot_sits_down() {
  robot_with_a_runtime
  start_run
  await '^driving$'
  kill -KILL "$run_pid"
  wait_run
  tries=0
  until grep -q "$msg_limp" "$LAB/out"; do
    [ $((tries += 1)) -lt 500 ] || fail "after kill -9 of darwinop run: $(cat "$LAB/out")"
    sleep 0.02
  done
  expect_limp
  start_run
  await '^driving$'
  kill -HUP -- "-$run_pid"
  wait_run
  expect_status 143
  expect_last_line "$msg_limp"
  start_run
  await '^driving$'
  kill -SEGV "$(pgrep -of '^bash .*/remote_client')"
  wait_run
  expect_status 139
  expect_last_line "$msg_limp"
}

# Neither side is notified: the PC's ssh is stopped.
scenario_a_pulled_cable_ends_the_server() {
  robot_with_a_runtime
  start_run
  await '^driving$'
  local begun=$SECONDS master; master=$(master_of_ssh)
  kill -STOP "$master"
  until ! pgrep -x darwinop-remote >/dev/null || [ $((SECONDS - begun)) -gt 20 ]; do sleep 0.05; done
  ! pgrep -x darwinop-remote >/dev/null || fail "the server was not ended"
  [ $((SECONDS - begun)) -ge 8 ] || fail "stopped after $((SECONDS - begun)) s: a short WLAN interruption would suffice"
  expect_limp
  kill -KILL "$master"
  wait_run
  expect_status 8 143
  expect_said "$login@$ADDRESS $msg_lost, .*$msg_state_unknown"
}

scenario_what_breaks_in_between_leaves_no_server() {
  robot_with_a_runtime
  start_run
  await '^driving$'
  kill -KILL "$(master_of_ssh)"
  wait_run
  expect_said "$login@$ADDRESS $msg_lost"
  expect_limp
  start_run
  await '^driving$'
  kill_shells
  wait_run
  expect_limp
  start_run
  await '^driving$'
  run_install --stop
  expect_status 0
  expect_said "$msg_remote_control .* stopped"
  wait_run
  expect_limp
}

scenario_refusals_say_what_to_do() {
  robot_with_a_runtime
  start_run --picture 100x100
  wait_run
  expect_status 2
  expect_said "'100x100'"
  start_sshd 'AllowTcpForwarding no'
  start_run
  wait_run
  expect_status 1
  expect_said 'AllowTcpForwarding'
  start_sshd
  # Another program on the robot drives.
  chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-remote --robot runtime --port 5999 >"$LAB/theirs" 2>&1 &
  until grep -qs ready "$LAB/theirs"; do sleep 0.02; done
  DARWINOP_ROBOT=tcp://127.0.0.1:5999 "$client" >"$LAB/their-client" 2>&1 &
  until grep -qs driving "$LAB/their-client"; do sleep 0.02; done
  start_run
  expect_pc_quiet() { :; }
  robot_quiet() { :; }
  wait_run
  expect_status 1
  expect_last_line "$msg_now_driven|\(process [0-9]+\) already" 2
  expect_said 'darwinop-remote \(process [0-9]+\) already'
  rm "$ROBOT/opt/darwinop/current/bin/darwinop-remote"
  start_run
  wait_run
  expect_status 1
  expect_said 'version real on this robot does not support remote control; upgrade it first: darwinop install'
}

run_scenarios "$@"
