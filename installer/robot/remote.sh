# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Remote control for as long as somebody at a PC is there: the robot's half of `darwinop run --robot tcp://USER@HOST`.
#
# stdin: an empty line a second says that the PC is there; another line answers a question; the end ends everything.
# stdout: "pose" asks what to do out of the start pose; "server PORT" says that the server listens on our loopback.

remote_link=      # folder of what the parts tell each other
remote_leave=0    # 1: the PC has left, or somebody told us to end
remote_claimed=0  # 1: nobody else's remote control or controller may begin
remote_server='' remote_ears='' remote_watch=''

# serve_remote FORCE TERMINAL WZ HZ WHO: status 0: served and ended, 3: not in the start pose, 130: told to end before.
serve_remote() {
  force=$1 terminal=$2 zooms="$3 $4" name="the remote control of $5"
  exec 3<&0 </dev/null
  begin_step
  need_runtime
  need_remote
  step "version $(version_current) is installed"
  claim_robot "$name"
  remote_claimed=1
  refuse_other_driver
  step "nobody else drives"
  attend_pc
  need_supervisor
  end_if_told
  stop_default_controller
  end_if_told
  need_daemon
  step "the runtime is ready"
  end_if_told
  [ "$force" = 1 ] || await_start_pose
  start_server
  wait_for_server
}

need_remote() {
  [ -x "$home/current/bin/darwinop-remote" ] ||
    die "version $(version_current) on this robot knows no remote control; upgrade it first: darwinop install"
}

begin_step() { read -r step_began _ </proc/uptime; }

# step SENTENCE: what was done, and how long it took.
step() {
  read -r step_ended _ </proc/uptime
  say "$* ($(echo "$step_began $step_ended" | awk '{ printf "%.1f", $2 - $1 }') s)"
  step_began=$step_ended
}

nap() { sleep 0.2 2>/dev/null || sleep 1; }

# Whoever holds the lease, but for the supervisor and its default controller, which are asked to end later.
refuse_other_driver() {
  driver=$(robot_driver)
  [ -n "$driver" ] || return 0
  ! is_default_controller "$driver" || return 0
  ! is_from_elsewhere "$driver" ||
    die "somebody drives this robot already, from a window on a PC (process $driver). Let them know, or stop it: darwinop install --stop"
  die "$(cat "/proc/$driver/comm" 2>/dev/null) (process $driver) drives this robot already, and was started on the robot itself. End it there with Ctrl-C, or: sudo kill -INT $driver"
}

is_default_controller() { supervisor --status 2>/dev/null | grep -v '^driver' | grep -q -e "pid $1\$" -e "pid $1,"; } # PID

# From here on whatever ends us, or the PC, ends the server, too, and says how the robot is.
attend_pc() {
  trap 'end_remote' EXIT
  trap 'leave_remote' TERM INT
  remote_link=$(mktemp -d /dev/shm/darwinop-remote-XXXXXX 2>/dev/null || mktemp -d) || die "cannot make a temporary folder"
  hear_pc &
  remote_ears=$!
  watch_pc &
  remote_watch=$!
  exec 3<&-
}

hear_pc() {
  exec <&3 3<&- >/dev/null
  trap - TERM INT
  count=0
  while IFS= read -r line; do
    count=$((count + 1))
    echo "$count" >"$remote_link/beats"
    [ -z "$line" ] || { echo "$line" >"$remote_link/answer.new" && mv -f "$remote_link/answer.new" "$remote_link/answer"; }
  done
  kill -TERM $$ 2>/dev/null
}

# A cable that was pulled ends nothing by itself.
watch_pc() {
  exec 3<&- >/dev/null
  trap - TERM INT
  quiet_s=0 last=
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    seen=
    read -r seen 2>/dev/null <"$remote_link/beats"
    if [ "$seen" = "$last" ]; then quiet_s=$((quiet_s + 1)); else quiet_s=0 last=$seen; fi
    [ "$quiet_s" -lt "$patience_s" ] || {
      say "nothing heard from the PC for $patience_s s: stopping"
      kill -TERM $$
      return
    }
  done
  rm -rf "$remote_link"
}

# On SIGTERM. What runs in the foreground ends first: a step that has begun is completed.
leave_remote() {
  remote_leave=1
  [ -z "$remote_server" ] || end_server
}

end_if_told() { [ "$remote_leave" = 0 ] || exit 130; }

end_server() {
  kill -TERM "$remote_server" 2>/dev/null
  { ended_within "$tidy_s" "$remote_server" || kill -KILL "$remote_server"; } >/dev/null 2>&1 &
}

stop_default_controller() {
  stopped=0
  supervisor_runs || return 0
  supervisor --stop-controller >/dev/null || die "the default controller could not be stopped; look at --logs"
  [ -L "$home/default" ] || return 0
  stopped=1
  step "the default controller is stopped; it starts again at the next boot"
}

# A robot that has just been stopped needs a moment to sit down.
await_start_pose() {
  tries=0
  until found=$("$home/current/bin/darwinop-runtime" --check-pose 2>&1); do
    end_if_told
    tries=$((tries + 1))
    if [ "$stopped" = 1 ] && [ $tries -lt 15 ]; then sleep 1 && continue; fi
    printf '%s\n' "$found" >&2
    [ "$terminal" = 1 ] ||
      die -3 "nothing was started: sit the robot down in its start pose and try again, or add --force when you hold it"
    ask_pc pose
    case $answer in
      go) step "start pose: not right, going on all the same"; return ;;
      retry) begin_step ;;
      *) say "cancelled; nothing was started"; exit 3 ;;
    esac
  done
  end_if_told
  step "start pose: right"
}

ask_pc() { # QUESTION -> answer
  rm -f "$remote_link/answer"
  echo "$1"
  until [ -s "$remote_link/answer" ]; do
    end_if_told
    nap
  done
  read -r answer <"$remote_link/answer"
}

start_server() {
  # shellcheck disable=SC2086  # two numbers
  "$home/current/bin/darwinop-remote" --robot runtime --end-with-parent --port 0 $zooms >"$remote_link/said" &
  remote_server=$!
  note_running "$(process_line "$remote_server")" "$name"
  await_port "$remote_server" "$remote_link/said" "the server of remote control"
  step "the server listens on port $port, on the robot's loopback only"
  echo "server $port"
}

await_port() { # PID FILE WHAT -> port
  until port=$(sed -n 's/^ready: .*:\([0-9]*\)[^0-9]*$/\1/p' "$2" 2>/dev/null) && [ -n "$port" ]; do
    end_if_told
    kill -0 "$1" 2>/dev/null || die "$3 does not start: see above"
    nap
  done
  end_if_told
}

# A signal ends `wait` early; the server has ended when there is nothing to wait for.
wait_for_server() {
  while kill -0 "$remote_server" 2>/dev/null; do
    wait "$remote_server"
    status=$?
  done
  # 143 is of a `wait` that SIGTERM has ended: the server listens to it. Its own status is lost where the shell was quicker.
  [ "$remote_leave$status" != 1143 ] || status=0
  [ "$remote_leave" = 1 ] || say "the server has ended (status $status); remote control is over"
  return "$status"
}

# However we end.
end_remote() {
  ending=$?
  trap '' TERM INT
  if [ -n "$remote_server" ] && kill -0 "$remote_server" 2>/dev/null; then
    end_server
    wait "$remote_server"
  fi
  # shellcheck disable=SC2086  # those that there are
  kill $remote_ears $remote_watch $remote_monitor 2>/dev/null
  tell_rest
  [ "$remote_claimed" = 0 ] || rm -f "$home/running"
  rm -rf "$remote_link"
  exit "$ending"
}

robot_driver() { "$home/current/bin/darwinop-runtime" --status 2>/dev/null | sed -n 's/^driver  *pid \([0-9]*\),.*/\1/p'; }
robot_state() { "$home/current/bin/darwinop-runtime" --status 2>/dev/null | sed -n 's/^state  *//p'; }

# The last line. A robot on its way down is waited for; one that holds may be about to kneel, or is told to hold.
tell_rest() {
  looks=0 limp=0 held=0 held_longest=15  # where nobody listens any more, `say` fails
  # A server that was killed has said no farewell: safety gives it up after gone_s.
  [ "${status:-0}" -lt 128 ] || held_longest=60
  while state=$(robot_state); do
    case $state in
      *limp*)
        # Seen twice: a client that had only just begun may be taking over.
        [ $limp = 0 ] || { say "the robot has let go: no joint has torque"; return; }
        limp=1 held=0
        ;;
      '') say "how the robot is cannot be told: no runtime answers. Look with: darwinop install --status"; return ;;
      offline*) say "how the robot is cannot be told: its board does not answer. Is its power on?"; return ;;
      holding*) limp=0 held=$((held + 1)) ;;
      driven*)
        driver=$(robot_driver)
        [ -z "$driver" ] || { say "the robot is driven by another program now, process $driver"; return; }
        ;;
      *) limp=0 held=0 ;;
    esac
    looks=$((looks + 1))
    if [ $held -ge $held_longest ] || [ $looks -ge 150 ]; then break; fi
    nap
  done
  say "the robot is still under torque ($state): hold it, or let go with 'darwinop runtime --release' on the robot, or with its MODE button"
}
