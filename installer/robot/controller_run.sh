# shellcheck shell=sh
# Runs a controller while the PC is connected: stdin has a heartbeat line per second and ends to stop it.

patience_s=10  # without a heartbeat from the PC; short WLAN interruptions are tolerated

# run_controller NAME FORCE ARGUMENTS...: status is the controller's, 128 + signal after a crash, 3: not in start pose.
run_controller() {
  name=$1 force=$2
  shift 2
  exec 3<&0 </dev/null
  need_runtime
  [ -x "$home/controllers/$name/$name" ] || die "there is no controller $name on this robot; send it with --controller"
  claim_robot "$name"
  refuse_other_driver
  need_supervisor
  stopped=0
  if supervisor_runs; then
    if [ -L "$home/default" ]; then
      say "$msg_stopping_default; it starts again at the next boot"
      stopped=1
    fi
    supervisor --stop-controller || die "cannot stop the default controller; see --logs"
  fi
  need_daemon
  [ "$force" = 1 ] || check_start_pose "$stopped"
  say "$name runs. Ctrl-C stops it"
  "$home/current/bin/darwinop-run" --robot runtime "$home/controllers/$name" -- "$@" 3<&- &
  runner=$!
  # Without this record --stop cannot find it: do not run.
  note_running "$(process_line "$runner")" "$name" || { stop_process "$runner" && die "cannot write to $home; $name is stopped"; }
  beats=$(mktemp /dev/shm/darwinop-link-XXXXXX 2>/dev/null || mktemp) || beats=/dev/null
  count_beats "$runner" <&3 &
  counter=$!
  watch_beats "$runner" 3<&- &
  watcher=$!
  exec 3<&-
  wait "$runner"
  status=$?
  kill "$counter" "$watcher" 2>/dev/null
  rm -f "$home/running" "$beats"
  # The PC describes crashes.
  case $status in 0 | 1[3-9]? | 129 | 2??) ;; *) say "${error_mark:-}$name ended with status $status" ;; esac
  return $status
}

process_line() { echo "$1 $(boot_id) $(process_age "$1")"; }

# One at a time. Waits for one that is ending.
claim_robot() {
  lock
  tries=0
  while is_running; do
    [ $tries -lt 3 ] || die "$(sed -n 3p "$home/running") $msg_already_running: darwinop install --stop"
    tries=$((tries + 1))
    sleep 1
  done
  note_running none "$1" || die "cannot write to $home"
  unlock
  trap 'rm -f "$home/running"' EXIT
}

# Records starter, process and name. Not with `put`: --stop would not find the process until its sync is done.
note_running() { # LINE|none NAME
  { lock_owner; printf '%s\n' "$1" "$2"; } >"$home/running.new-$$" && mv -f "$home/running.new-$$" "$home/running"
}

is_running() { lock_alive "$(sed -n 1p "$home/running" 2>/dev/null)" || lock_alive "$(sed -n 2p "$home/running" 2>/dev/null)"; }

daemon_ready() { "$home/current/bin/darwinop-runtime" --status >/dev/null 2>&1; }

# The supervisor; after a failed start or an operator's --stop it may not run.
need_supervisor() {
  if daemon_ready || supervisor_runs; then return; fi
  launch_supervisor
  tries=0
  until supervisor_runs; do
    tries=$((tries + 1))
    [ $tries -lt 10 ] || die "the supervisor does not start: $(last_log_line). See --logs"
    sleep 1
  done
}

need_daemon() {
  tries=0
  until daemon_ready; do
    tries=$((tries + 1))
    [ $tries -lt 20 ] || die "the runtime does not start: $(last_log_line). Check the robot's power; see --logs"
    sleep 1
  done
}

last_log_line() { tail -n 1 "$home/log/supervisor.log" 2>/dev/null; }

# A robot that was just stopped needs time to sit down.
check_start_pose() { # STOPPED
  tries=0
  until found=$("$home/current/bin/darwinop-runtime" --check-pose 2>&1); do
    tries=$((tries + 1))
    if [ "$1" = 0 ] || [ $tries -ge 15 ]; then
      printf '%s\n' "$found" >&2
      die -3 "$msg_sit_down"
    fi
    sleep 1
  done
}

# Heartbeat lines on stdin. Their end is Ctrl-C at the PC or a closed connection.
count_beats() { # PID
  count=0
  while read -r _; do
    count=$((count + 1))
    echo "$count" >"$beats"
  done
  stop_process "$1"
}

# An unplugged cable does not close the connection; only the heartbeat stops.
watch_beats() { # PID
  quiet_s=0 last=
  while sleep 1 && kill -0 "$1" 2>/dev/null; do
    seen=
    read -r seen <"$beats"
    if [ "$seen" = "$last" ]; then quiet_s=$((quiet_s + 1)); else quiet_s=0 last=$seen; fi
    [ $quiet_s -lt $patience_s ] || {
      say "no heartbeat from the PC for $patience_s s: stopping"
      stop_process "$1"
      return
    }
  done
}
