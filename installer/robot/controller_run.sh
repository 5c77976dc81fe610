# shellcheck shell=sh
# A sent controller for as long as somebody at a PC is there: stdin brings a line a second and ends when it shall stop.

patience_s=10  # without a sign of life from the PC; a WLAN that hiccups comes back sooner
tidy_s=10      # to end after SIGINT: a step, what the controller does at its end, the farewell

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
      say "stopping the default controller; it starts again at the next boot"
      stopped=1
    fi
    supervisor --stop-controller || die "the default controller could not be stopped; look at --logs"
  fi
  need_daemon
  [ "$force" = 1 ] || check_start_pose "$stopped"
  say "$name runs. Ctrl-C stops it"
  "$home/current/bin/darwinop-run" --robot runtime "$home/controllers/$name" -- "$@" 3<&- &
  runner=$!
  note_running "$(process_line "$runner")" "$name"
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
  # A crash is said in words at the PC.
  case $status in 0 | 1[3-9]? | 129 | 2??) ;; *) say "${error_mark:-}$name ended with status $status" ;; esac
  return $status
}

process_line() { echo "$1 $(boot_id) $(process_age "$1")"; }

# One at a time. Who asks first has it; one that is just ending is waited for.
claim_robot() {
  lock
  tries=0
  while is_running; do
    [ $tries -lt 3 ] || die "$(sed -n 3p "$home/running") runs on this robot already; stop it first: darwinop install --stop"
    tries=$((tries + 1))
    sleep 1
  done
  note_running none "$1" || die "cannot write into $home"
  unlock
  trap 'rm -f "$home/running"' EXIT
}

# Who started it, what runs, its name. No `put`: until its sync is done --stop would not find what already runs.
note_running() { # LINE|none NAME
  { lock_owner; printf '%s\n' "$1" "$2"; } >"$home/running.new-$$" && mv -f "$home/running.new-$$" "$home/running"
}

is_running() { lock_alive "$(sed -n 1p "$home/running" 2>/dev/null)" || lock_alive "$(sed -n 2p "$home/running" 2>/dev/null)"; }

daemon_ready() { "$home/current/bin/darwinop-runtime" --status >/dev/null 2>&1; }

# What boot starts; after a failed start or an operator's --stop there may be none.
need_supervisor() {
  if daemon_ready || supervisor_runs; then return; fi
  launch_supervisor
  tries=0
  until supervisor_runs; do
    tries=$((tries + 1))
    [ $tries -lt 10 ] || die "the supervisor does not start: $(last_log_line). More with --logs"
    sleep 1
  done
}

need_daemon() {
  tries=0
  until daemon_ready; do
    tries=$((tries + 1))
    [ $tries -lt 20 ] || die "the runtime does not come up: $(last_log_line). Is the robot's power on? More with --logs"
    sleep 1
  done
}

last_log_line() { tail -n 1 "$home/log/supervisor.log" 2>/dev/null; }

# A robot that has just been stopped needs a moment to sit down.
check_start_pose() { # STOPPED
  tries=0
  until found=$("$home/current/bin/darwinop-runtime" --check-pose 2>&1); do
    tries=$((tries + 1))
    if [ "$1" = 0 ] || [ $tries -ge 15 ]; then
      printf '%s\n' "$found" >&2
      die -3 "nothing was started: sit the robot down in its start pose and try again, or add --force when you hold it"
    fi
    sleep 1
  done
}

# Lines of stdin. Their end is Ctrl-C at the PC, or a link that was closed.
count_beats() { # PID
  count=0
  while read -r _; do
    count=$((count + 1))
    echo "$count" >"$beats"
  done
  stop_process "$1"
}

# A cable that was pulled ends nothing by itself: the far end only falls silent.
watch_beats() { # PID
  quiet_s=0 last=
  while sleep 1 && kill -0 "$1" 2>/dev/null; do
    seen=
    read -r seen <"$beats"
    if [ "$seen" = "$last" ]; then quiet_s=$((quiet_s + 1)); else quiet_s=0 last=$seen; fi
    [ $quiet_s -lt $patience_s ] || {
      say "nothing heard from the PC for $patience_s s: stopping"
      stop_process "$1"
      return
    }
  done
}

# stop_process PID: of darwinop-run. SIGINT, as Ctrl-C; who does not listen is asked again, then killed with its children.
stop_process() {
  kill -INT "$1" 2>/dev/null
  ended_within $tidy_s "$1" && return
  say "the controller does not end; it is ended now"
  kill -INT "$1" 2>/dev/null  # for programs of our library the second one is deadly
  ended_within 3 "$1" && return
  for stat in /proc/[0-9]*/stat; do
    # Field 4, the parent; the name in field 2 may hold anything.
    [ "$(sed 's/^.*) //' "$stat" 2>/dev/null | cut -d ' ' -f 2)" = "$1" ] || continue
    child=${stat#/proc/}
    kill -KILL "${child%/stat}" 2>/dev/null
  done
  ended_within 3 "$1" || kill -KILL "$1" 2>/dev/null
}

ended_within() { # SECONDS PID
  waited=0
  while kill -0 "$2" 2>/dev/null; do
    [ $waited -lt "$1" ] || return 1
    waited=$((waited + 1))
    sleep 1
  done
}

stop_sent_controller() {
  is_running || return 0
  name=$(sed -n 3p "$home/running")
  # While it is being prepared there is nothing to stop yet.
  tries=0
  until runner=$(sed -n 2p "$home/running" 2>/dev/null) && lock_alive "$runner"; do
    is_running || return 0
    [ $tries -lt 15 ] || break
    tries=$((tries + 1))
    sleep 1
  done
  if lock_alive "$runner"; then
    stop_process "${runner%% *}"
  else
    owner=$(sed -n 1p "$home/running")
    kill "${owner%% *}" 2>/dev/null
  fi
  say "$name is stopped"
}
