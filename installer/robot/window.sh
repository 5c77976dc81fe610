# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Robot side of `darwinop window --robot tcp://USER@HOST`: monitor and server on loopback.
#
# Observing does not interfere: no lease is taken and other drivers continue. The server holds the lease only while a user
# drives in the window. The web page asks about the start pose.

remote_monitor=

# serve_window: stdin and status as for serve_remote; stdout: "server PORT MONITORS-PORT" once both listen.
serve_window() {
  exec 3<&0 </dev/null
  begin_step
  need_runtime
  need_remote
  "$home/current/bin/darwinop-monitor" --help 2>/dev/null | grep -q -e --end-with-parent ||
    die "version $(version_current) on this robot has no monitor for the window; upgrade it first: darwinop install"
  step "version $(version_current) is installed"
  attend_pc
  wake_runtime
  end_if_requested
  report_driver
  start_for_window
  wait_for_server
}

# Only if it does not cause motion. A runtime that starts later is shown then.
wake_runtime() {
  if ! daemon_ready && ! supervisor_runs; then
    [ ! -L "$home/default" ] || {
      say "no runtime runs, and starting it would also start the default controller. Restart the robot: the window shows it as soon as a runtime runs"
      return
    }
    # During an installation a start would revert the version under test.
    (lock && need_supervisor) || {
      say "$msg_no_start. The window shows the robot as soon as a runtime runs"
      return
    }
  fi
  tries=0
  until daemon_ready; do
    end_if_requested
    [ $tries -lt 5 ] || {
      say "the runtime does not start: $(last_log_line). Check the robot's power. The window shows the robot as soon as a runtime runs"
      return
    }
    tries=$((tries + 1))
    sleep 1
  done
  step "$msg_ready"
}

report_driver() {
  driver=$(robot_driver)
  [ -n "$driver" ] || return 0
  say "$(cat "/proc/$driver/comm" 2>/dev/null) (process $driver) drives this robot, and the window observes. To drive from the window, end it first: darwinop install --stop"
}

start_for_window() {
  "$home/current/bin/darwinop-monitor" --end-with-parent --port 0 >"$remote_link/monitor" &
  remote_monitor=$!
  "$home/current/bin/darwinop-remote" --robot runtime --end-with-parent --port 0 >"$remote_link/said" &
  remote_server=$!
  await_port "$remote_monitor" "$remote_link/monitor" "the monitor"
  monitor_port=$port
  await_port "$remote_server" "$remote_link/said" "the server of remote control"
  step "monitor and server listen on ports $monitor_port and $port, on the robot's loopback only"
  watch_monitor &
  remote_watch="$remote_watch $!"
  echo "server $port $monitor_port"
}

# Without the monitor the window shows nothing: it ends with a message.
watch_monitor() {
  exec >/dev/null
  trap - TERM INT
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    kill -0 "$remote_monitor" 2>/dev/null || {
      say "the monitor has ended, so the window ends; see above for the reason"
      kill -TERM $$
      return
    }
  done
}

# is_from_elsewhere PID: true for a server that drives for a PC and ends with its login shell.
is_from_elsewhere() { tr '\0' ' ' <"/proc/$1/cmdline" 2>/dev/null | grep -q -e '^[^ ]*darwinop-remote .*--end-with-parent'; }

# Ends a window that drives; one that observes continues.
stop_driving_window() {
  driver=$(robot_driver)
  if [ -z "$driver" ] || ! is_from_elsewhere "$driver"; then return 0; fi
  kill -TERM "$driver" 2>/dev/null
  ended_within "$end_s" "$driver" || kill -KILL "$driver" 2>/dev/null
  say "$msg_window_stopped"
}
