# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# PC side of `darwinop run` and `darwinop window --robot tcp://USER@HOST`: starts the server on the robot, for the window
# also the monitor, and forwards local ports to them.
#
#   darwinop-install --remote [--picture 160x120] [--force] [--tell PID] [ssh options] USER@HOST
#   darwinop-install --remote --window [ssh options] USER@HOST
#
# stdout: "ready PORT" once 127.0.0.1:PORT is forwarded to the server, for the window "ready PORT MONITORS-PORT". Runs until
# stdin ends. An earlier end sends SIGINT to PID. Status: 0 ended on request, else failed with a message.

notify_pid=   # process that gets SIGINT at an early end
picture=      # WIDTHxHEIGHT
window=0      # 1: for a window: other drivers continue, the pose is not checked

remote_main() {
  program="darwinop run"
  [ "$window" = 0 ] || program="darwinop window"
  begin_step
  exec 5<&0 </dev/null
  # If the caller is killed, stdin ends. Read in the background, since `wait` and ssh block this shell.
  watch_caller &
  caller=$!
  exec 5<&-
  say "connecting to $target"
  connect
  step "connected to $target"
  mkfifo "$connection/messages" || die "cannot write to $connection"
  follow_robot <"$connection/messages" &
  follower=$!
  terminal=0
  ! on_terminal || terminal=1
  on_signal=remote_signal
  if [ "$window" = 1 ]; then
    attended "the window's half on the robot" serve_window >"$connection/messages"
  else
    # shellcheck disable=SC2086  # two numbers
    attended "remote control" serve_remote "$force" "$terminal" $zooms "$(id -un)@$(uname -n)" >"$connection/messages"
  fi
  status=$?
  kill "$caller" "$follower" 2>/dev/null
  trap '' INT TERM HUP
  [ ! -e "$connection/asked" ] || echo >/dev/tty  # after an unanswered question
  [ $status != 255 ] || report_lost_link
  [ ! -e "$connection/failed" ] || status=1
  [ -z "$notify_pid" ] || [ "$asked_to_stop" = 1 ] || [ ! -e "$connection/ready" ] || kill -INT "$notify_pid" 2>/dev/null
  exit $status
}

begin_step() { read -r step_began _ </proc/uptime; }

# step TEXT: prints what was done, with its duration.
step() {
  read -r step_ended _ </proc/uptime
  say "$* ($(echo "$step_began $step_ended" | awk '{ printf "%.1f", $2 - $1 }') s)"
  step_began=$step_ended
}

watch_caller() {
  exec <&5 5<&- >/dev/null  # a redirected function would keep a copy of stdout open, for which the caller waits
  trap '' HUP
  while read -r _; do :; done
  kill -TERM $$ 2>/dev/null
}

# While a controller drives or the window is open, they handle Ctrl-C and need the connection for a normal end.
remote_signal() {
  if { [ -n "$notify_pid" ] || [ "$window" = 1 ]; } && [ -e "$connection/ready" ] && [ "$asked_to_stop" = 0 ]; then return; fi
  ask_to_stop
}

follow_robot() {
  trap '' HUP
  while read -r word numbers; do
    case $word in
      pose)
        ask_about_pose
        rm -f "$connection/asked"
        echo "$answer" >"$connection/attended"  # opened only now: while open, the end of stdin is not detected
        ;;
      server)
        begin_step
        # shellcheck disable=SC2086  # one word per port
        open_forwards $numbers && continue
        [ ! -e "$connection/stopping" ] || continue
        : >"$connection/failed"
        kill -TERM $$
        ;;
    esac
  done
}

# The three choices of the simulator's robot window.
ask_about_pose() { # -> answer
  : >"$connection/asked"
  while :; do
    printf '%s' "The robot is not in its start pose. [r]etry, [g]o on (hold the robot: it moves slowly into it), [c]ancel? " >/dev/tty
    IFS= read -r choice </dev/tty || choice=c
    case $choice in
      [rR]*) answer=retry && return ;;
      [gG]*) answer=go && return ;;
      [cC]*) answer=cancel && return ;;
    esac
  done
}

open_forwards() { # PORTS-OF-THE-ROBOT
  local_ports=
  for robot_port; do
    open_forward "$robot_port" || return 1
    local_ports="$local_ports $local_port"
    step "127.0.0.1:$local_port on this PC is forwarded to port $robot_port on the robot"
  done
  : >"$connection/ready"
  echo "ready$local_ports"
}

# A free local port on loopback, below 32768, outside the ephemeral range.
open_forward() { # PORT-OF-THE-ROBOT -> local_port
  tries=0
  while :; do
    local_port=$((20000 + $(od -An -N2 -tu2 /dev/urandom) % 12000))
    ssh_call -O forward -L "127.0.0.1:$local_port:127.0.0.1:$1" "$target" >"$connection/forward" 2>&1 && break
    [ ! -e "$connection/stopping" ] || return 1
    tries=$((tries + 1))
    [ $tries -lt 20 ] || {
      say "cannot forward a port of this PC to the robot; ssh:  $(tail -n 1 "$connection/forward" | tr -d '\r')"
      return 1
    }
  done
  # sshd may forbid forwarding and reports that only at the first connection.
  ssh_with "-o ProxyCommand=false" -o ControlMaster=no -o BatchMode=yes -W "127.0.0.1:$1" "$target" \
    </dev/null >/dev/null 2>"$connection/forward" || {
    [ ! -e "$connection/stopping" ] || return 1  # the server has ended
    say "ssh on $target does not forward to port $1:  $(tail -n 1 "$connection/forward" | tr -d '\r'); set AllowTcpForwarding yes in its /etc/ssh/sshd_config"
    return 1
  }
}

report_lost_link() {
  status=1
  it="It"
  [ "$window" = 0 ] || it="$msg_if_driven, it"
  say "the connection to $target $msg_lost, so the robot's state is unknown. $it stops, ends remote control within 10 s and sits down (or holds, see [Safety] on_exit). In an emergency press MODE on its back; check with: darwinop install --status $target"
}

# 320x240 and its halves, as divisors of each side.
check_picture() { # -> zooms
  zooms="1 1"
  [ -n "$picture" ] || return 0
  zooms=
  case $picture in 320x*) zooms=1 ;; 160x*) zooms=2 ;; 80x*) zooms=4 ;; 40x*) zooms=8 ;; esac
  case $picture in *x240) zooms="$zooms 1" ;; *x120) zooms="$zooms 2" ;; *x60) zooms="$zooms 4" ;; *x30) zooms="$zooms 8" ;; *) zooms= ;; esac
  case $zooms in [1248]" "[1248]) ;; *) wrong_usage "--picture requires a width of 320, 160, 80 or 40 and a height of 240, 120, 60 or 30, such as 160x120, not '$picture'" ;; esac
}
