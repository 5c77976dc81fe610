# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Robot side of `darwinop run --robot tcp://USER@HOST`: remote control while the PC is connected.
#
# stdin: an empty line per second is the heartbeat; another line answers a question; EOF ends everything.
# stdout: "pose" asks what to do outside the start pose; "server PORT": the server listens on loopback.

remote_claimed=0  # 1: no other remote control or controller may start
remote_server=

# serve_remote FORCE TERMINAL WZ HZ WHO: status 0: served and ended, 3: not in the start pose, 130: ended before.
serve_remote() {
  force=$1 terminal=$2 zooms="$3 $4" name="$msg_remote_control $5"
  exec 3<&0 </dev/null
  begin_step
  need_runtime
  need_remote
  step "version $(version_current) is installed"
  claim_robot "$name"
  remote_claimed=1
  refuse_other_driver
  step "no other program drives"
  attend_pc
  need_supervisor
  end_if_requested
  stop_default_controller
  end_if_requested
  need_daemon
  step "$msg_ready"
  end_if_requested
  [ "$force" = 1 ] || await_start_pose
  start_server
  wait_for_server
}

need_remote() {
  [ -x "$home/current/bin/darwinop-remote" ] ||
    die "version $(version_current) on this robot does not support remote control; upgrade it first: darwinop install"
}

begin_step() { read -r step_began _ </proc/uptime; }

# step TEXT: prints what was done, with its duration.
step() {
  read -r step_ended _ </proc/uptime
  say "$* ($(echo "$step_began $step_ended" | awk '{ printf "%.1f", $2 - $1 }') s)"
  step_began=$step_ended
}

nap() { sleep 0.2 2>/dev/null || sleep 1; }

# Rejects other holders of the lease; supervisor and default controller are stopped later.
refuse_other_driver() {
  driver=$(robot_driver)
  [ -n "$driver" ] || return 0
  ! is_default_controller "$driver" || return 0
  ! is_from_elsewhere "$driver" ||
    die "$msg_driven_from_window (process $driver). End it there, or stop it: darwinop install --stop"
  die "$(cat "/proc/$driver/comm" 2>/dev/null) (process $driver) already drives this robot and was started on the robot itself. End it there with Ctrl-C, or: sudo kill -INT $driver"
}

is_default_controller() { supervisor --status 2>/dev/null | grep -v '^driver' | grep -q -e "pid $1\$" -e "pid $1,"; } # PID

end_server() {
  kill -TERM "$remote_server" 2>/dev/null
  { ended_within "$end_s" "$remote_server" || kill -KILL "$remote_server"; } >/dev/null 2>&1 &
}

stop_default_controller() {
  stopped=0
  supervisor_runs || return 0
  supervisor --stop-controller >/dev/null || die "cannot stop the default controller; see --logs"
  [ -L "$home/default" ] || return 0
  stopped=1
  step "the default controller is stopped; it starts again at the next boot"
}

# A robot that was just stopped needs time to sit down.
await_start_pose() {
  tries=0
  until found=$("$home/current/bin/darwinop-runtime" --check-pose 2>&1); do
    end_if_requested
    tries=$((tries + 1))
    if [ "$stopped" = 1 ] && [ $tries -lt 15 ]; then sleep 1 && continue; fi
    printf '%s\n' "$found" >&2
    [ "$terminal" = 1 ] ||
      die -3 "$msg_sit_down"
    ask_pc pose
    case $answer in
      go) step "$msg_pose_wrong"; return ;;
      retry) begin_step ;;
      *) say "$msg_cancelled"; exit 3 ;;
    esac
  done
  end_if_requested
  step "$msg_pose_ok"
}

start_server() {
  # shellcheck disable=SC2086  # two numbers
  "$home/current/bin/darwinop-remote" --robot runtime --end-with-parent --port 0 $zooms >"$remote_link/said" &
  remote_server=$!
  note_running "$(process_line "$remote_server")" "$name" || die "cannot write to $home"
  await_port "$remote_server" "$remote_link/said" "the server of remote control"
  step "the server listens on port $port, on the robot's loopback only"
  echo "server $port"
}

await_port() { # PID FILE WHAT -> port
  until port=$(sed -n 's/^ready: .*:\([0-9]*\)[^0-9]*$/\1/p' "$2" 2>/dev/null) && [ -n "$port" ]; do
    end_if_requested
    kill -0 "$1" 2>/dev/null || die "$3 does not start: see above"
    nap
  done
  end_if_requested
}

# A signal ends `wait` early; the server has ended when there is no child.
wait_for_server() {
  while kill -0 "$remote_server" 2>/dev/null; do
    wait "$remote_server"
    status=$?
  done
  # 143: `wait` was interrupted by SIGTERM, which the server handles. Its own status may be lost.
  [ "$remote_leave$status" != 1143 ] || status=0
  [ "$remote_leave" = 1 ] || say "the server has ended (status $status); remote control is over"
  return "$status"
}

# At any end.
end_remote() {
  ending=$?
  trap '' TERM INT
  if [ -n "$remote_server" ] && kill -0 "$remote_server" 2>/dev/null; then
    end_server
    wait "$remote_server"
  fi
  # shellcheck disable=SC2086  # existing ones
  kill $remote_ears $remote_watch $remote_monitor 2>/dev/null
  report_rest
  [ "$remote_claimed" = 0 ] || rm -f "$home/running"
  rm -rf "$remote_link"
  exit "$ending"
}
