# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Programs on the robot: stop, self-test, start.

others_ended=

# bring_to_rest: ends the controller, lets the robot sit down, ends daemon and supervisor. Returns when done. Fails without
# --force if a joint may be under torque.
bring_to_rest() {
  [ -x "$home/current/bin/darwinop-supervisor" ] || return 0
  say "bringing the robot to rest"
  within 240 "$home/current/bin/darwinop-supervisor" --stop >&2 </dev/null || {
    [ "$force" = 1 ] ||
      die "the supervisor did not bring the robot to rest, see above; nothing was changed. Restart the robot, or add --force"
    say "the robot may be under torque, see above: hold it; continuing because of --force"
  }
  # A unit that failed waits for its next automatic start, which would take back the version under test.
  ! has_unit || within 250 systemctl stop darwinop.service || say "systemd did not stop darwinop.service; see 'systemctl status darwinop'"
}

has_unit() { [ -d /run/systemd/system ] && [ -f "$(unit_file)" ] && command -v systemctl >/dev/null 2>&1; }

# The ROBOTIS demo and what Webots installs (default controller, remote control) use the serial port without a lock, so
# the runtime would open it as well. They end on SIGTERM; the servos keep their last goals.
end_other_programs() {
  for process in /proc/[0-9]*; do
    case $(readlink "$process/exe" 2>/dev/null) in
      */Linux/project/demo/demo) other="the ROBOTIS demo" ;;
      */Linux/project/webots/*) other="a program that Webots installed" ;;
      *) continue ;;
    esac
    say "ending $other (process ${process#/proc/}); the servos keep their pose"
    others_ended=1
    kill -TERM "${process#/proc/}" 2>/dev/null
    seconds=0
    while [ -d "$process" ] && [ "$seconds" -lt 5 ]; do
      sleep 1
      seconds=$((seconds + 1))
    done
  done
}

# self_test: runs darwinop-doctor of the new version on the robot's port; its output goes to stdout, since it is not an error.
self_test() {
  if [ "$without_robot" = 1 ]; then
    say "no self-test because of --without-robot; run 'darwinop install --status' and $home/current/bin/darwinop-doctor later"
    return 0
  fi
  say "self-test of version $target on $(robot_port)"
  within 120 "$home/versions/$target/bin/darwinop-doctor" --robot "$(robot_port)" </dev/null
}

# within SECONDS COMMAND...: its status, or 1 after a timeout. (Some robots lack `timeout`.)
within() {
  limit=$1
  shift
  "$@" &
  child=$!
  (
    # Must not keep the connection open; ends with the program.
    exec >/dev/null 2>&1
    while [ "$limit" -gt 0 ] && kill -0 "$child"; do
      sleep 1
      limit=$((limit - 1))
    done
    kill -KILL "$child"
  ) &
  guard=$!
  wait "$child"
  result=$?
  kill "$guard" 2>/dev/null
  wait "$guard" 2>/dev/null
  [ "$result" -lt 128 ] || say "timed out, or ended by signal $((result - 128))"
  return "$result"
}

# start_supervisor: as at boot, independent of this connection.
start_supervisor() {
  if [ "$without_robot" = 1 ] || [ "$(autostart_kind)" = none ]; then
    say "not starting the supervisor"
    return 0
  fi
  ! default=$(readlink "$home/default") ||
    say "$msg_keep_clear: ${default##*/} starts in the start pose, unless it was stopped or had ended"
  launch_supervisor
}

launch_supervisor() {
  if has_unit; then
    systemctl daemon-reload
    systemctl restart darwinop.service || say "systemd did not start darwinop.service; see 'systemctl status darwinop'"
    return 0
  fi
  free=
  for program in nohup setsid; do
    if command -v "$program" >/dev/null 2>&1; then free="$free $program"; fi
  done
  # shellcheck disable=SC2086
  (cd / && trap - PIPE && exec $free "$home/start") </dev/null >/dev/null 2>&1 &
  await_supervisor
}

await_supervisor() {
  tries=0
  while [ "$tries" -lt 10 ]; do
    tries=$((tries + 1))
    if "$home/current/bin/darwinop-supervisor" --status >/dev/null 2>&1 </dev/null; then
      say "the supervisor is running"
      return
    fi
    sleep 0.3 2>/dev/null || sleep 1
  done
  say "the supervisor has not started yet; check with --status and $home/log/supervisor.log"
}
