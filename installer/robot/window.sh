# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The robot's half of `darwinop window --robot tcp://USER@HOST`: monitor and server, on our loopback alone.
#
# Whoever looks on disturbs nobody: the robot is not claimed, and who drives goes on. The server takes the driving lease
# when somebody drives in the window, and gives it back when they let go. The page asks about the start pose.

remote_monitor=

# serve_window: stdin and status as of serve_remote; stdout: "server PORT MONITORS-PORT" once both listen.
serve_window() {
  exec 3<&0 </dev/null
  begin_step
  need_runtime
  need_remote
  "$home/current/bin/darwinop-monitor" --help 2>/dev/null | grep -q -e --end-with-parent ||
    die "version $(version_current) on this robot has no monitor that a window could look through; upgrade it first: darwinop install"
  step "version $(version_current) is installed"
  attend_pc
  wake_runtime
  end_if_told
  tell_driver
  start_for_window
  wait_for_server
}

# Only where nothing moves because of it. What does not come up is seen in the window as soon as it does.
wake_runtime() {
  if ! daemon_ready && ! supervisor_runs; then
    [ ! -L "$home/default" ] || {
      say "no runtime runs, and none is started from here, as the default controller would start with it. Switch the robot off and on: the window shows it as soon as there is one"
      return
    }
    # While somebody installs, a start would take back the version that is being tested.
    (lock && need_supervisor) || {
      say "no runtime is started from here: see above. The window shows the robot as soon as there is one"
      return
    }
  fi
  tries=0
  until daemon_ready; do
    end_if_told
    [ $tries -lt 5 ] || {
      say "the runtime does not come up: $(last_log_line). Is the robot's power on? The window shows the robot as soon as it does"
      return
    }
    tries=$((tries + 1))
    sleep 1
  done
  step "the runtime is ready"
}

tell_driver() {
  driver=$(robot_driver)
  [ -n "$driver" ] || return 0
  end_it="darwinop install --stop"
  is_running || is_default_controller "$driver" || is_from_elsewhere "$driver" || end_it="sudo kill -INT $driver (on the robot)"
  say "$(cat "/proc/$driver/comm" 2>/dev/null) (process $driver) drives this robot, and the window looks on. To drive from the window, end it first: $end_it"
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

# Without it a window shows nothing: it ends, and says so.
watch_monitor() {
  exec >/dev/null
  trap - TERM INT
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    kill -0 "$remote_monitor" 2>/dev/null || {
      say "the monitor has ended, and the window with it. More may stand above"
      kill -TERM $$
      return
    }
  done
}

# is_from_elsewhere PID: a server that drives for a PC, and ends when the shell of its login does.
is_from_elsewhere() { tr '\0' ' ' <"/proc/$1/cmdline" 2>/dev/null | grep -q -e '^[^ ]*darwinop-remote .*--end-with-parent'; }

# A window that drives ends; one that looks on goes on.
stop_driving_window() {
  driver=$(robot_driver)
  if [ -z "$driver" ] || ! is_from_elsewhere "$driver"; then return 0; fi
  kill -TERM "$driver" 2>/dev/null
  ended_within "$tidy_s" "$driver" || kill -KILL "$driver" 2>/dev/null
  say "the window that drove this robot is stopped"
}
