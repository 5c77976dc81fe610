# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# `darwinop run` and `darwinop window --robot tcp://USER@HOST` have this done: the server on the robot, for the window its
# monitor, too, and ports of this PC that lead to them.
#
#   darwinop-install --remote [--picture 160x120] [--force] [--tell PID] [ssh options] USER@HOST
#   darwinop-install --remote --window [ssh options] USER@HOST
#
# stdout: "ready PORT" once 127.0.0.1:PORT leads to the server, for the window "ready PORT MONITORS-PORT". It goes on until
# stdin ends. What ends before that sends SIGINT to PID. Status: 0 ended as asked, else nothing is ready (any more) and it
# has been said why.

tell=         # process that wants to know
picture=      # WIDTHxHEIGHT
window=0      # 1: for a window: nobody is sent away, the pose is not looked at

remote_main() {
  program="darwinop run"
  [ "$window" = 0 ] || program="darwinop window"
  begin_step
  exec 5<&0 </dev/null
  # Who called us may be killed: then stdin ends. In the background, as `wait` and ssh keep this shell busy.
  watch_caller &
  caller=$!
  exec 5<&-
  say "connecting to $target"
  connect
  step "connected to $target"
  mkfifo "$connection/told" || die "cannot write to $connection"
  follow_robot <"$connection/told" &
  follower=$!
  terminal=0
  ! on_terminal || terminal=1
  on_signal=remote_signal
  if [ "$window" = 1 ]; then
    attended "the window's half on the robot" serve_window >"$connection/told"
  else
    # shellcheck disable=SC2086  # two numbers
    attended "remote control" serve_remote "$force" "$terminal" $zooms "$(id -un)@$(uname -n)" >"$connection/told"
  fi
  status=$?
  kill "$caller" "$follower" 2>/dev/null
  trap '' INT TERM HUP
  [ ! -e "$connection/asked" ] || echo >/dev/tty  # behind a question that was never answered
  [ $status != 255 ] || tell_lost_link
  [ ! -e "$connection/failed" ] || status=1
  [ -z "$tell" ] || [ "$asked_to_stop" = 1 ] || [ ! -e "$connection/ready" ] || kill -INT "$tell" 2>/dev/null
  exit $status
}

begin_step() { read -r step_began _ </proc/uptime; }

# step SENTENCE: what was done, and how long it took.
step() {
  read -r step_ended _ </proc/uptime
  say "$* ($(echo "$step_began $step_ended" | awk '{ printf "%.1f", $2 - $1 }') s)"
  step_began=$step_ended
}

watch_caller() {
  exec <&5 5<&- >/dev/null  # redirections of a function would leave a copy of stdout, which the caller waits for
  trap '' HUP
  while read -r _; do :; done
  kill -TERM $$ 2>/dev/null
}

# Once a controller drives, or the window is open, Ctrl-C is its affair: it may want to end tidily, and needs the
# connection for that.
remote_signal() {
  if { [ -n "$tell" ] || [ "$window" = 1 ]; } && [ -e "$connection/ready" ] && [ "$asked_to_stop" = 0 ]; then return; fi
  ask_to_stop
}

follow_robot() {
  trap '' HUP
  while read -r word numbers; do
    case $word in
      pose)
        ask_about_pose
        rm -f "$connection/asked"
        echo "$answer" >"$connection/attended"  # opened only now: while it is open, nobody hears that we want to end
        ;;
      server)
        begin_step
        # shellcheck disable=SC2086  # one port a word
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
    step "127.0.0.1:$local_port on this PC leads to port $robot_port there"
  done
  : >"$connection/ready"
  echo "ready$local_ports"
}

# A free port of this PC, on loopback. Below 32768, where nobody gets one by chance.
open_forward() { # PORT-OF-THE-ROBOT -> local_port
  tries=0
  while :; do
    local_port=$((20000 + $(od -An -N2 -tu2 /dev/urandom) % 12000))
    ssh_call -O forward -L "127.0.0.1:$local_port:127.0.0.1:$1" "$target" >"$connection/forward" 2>&1 && break
    [ ! -e "$connection/stopping" ] || return 1
    tries=$((tries + 1))
    [ $tries -lt 20 ] || {
      say "no port of this PC could be forwarded to the robot; ssh says: $(tail -n 1 "$connection/forward" | tr -d '\r')"
      return 1
    }
  done
  # sshd may forbid it, and says so only when somebody comes.
  ssh_with "-o ProxyCommand=false" -o ControlMaster=no -o BatchMode=yes -W "127.0.0.1:$1" "$target" \
    </dev/null >/dev/null 2>"$connection/forward" || {
    [ ! -e "$connection/stopping" ] || return 1  # the server has ended
    say "ssh on $target does not forward to its own port $1: $(tail -n 1 "$connection/forward" | tr -d '\r'). Its /etc/ssh/sshd_config needs: AllowTcpForwarding yes"
    return 1
  }
}

tell_lost_link() {
  status=1
  it="It"
  [ "$window" = 0 ] || it="If the window drove it, it"
  say "the link to $target was lost, so how the robot is cannot be told. $it stops where it is, ends remote control within 10 s and sits down (or holds, as [Safety] on_exit says). In danger press MODE on its back; look with: darwinop install --status $target"
}

# 320x240 and its halves, as divisors of each side.
check_picture() { # -> zooms
  zooms="1 1"
  [ -n "$picture" ] || return 0
  zooms=
  case $picture in 320x*) zooms=1 ;; 160x*) zooms=2 ;; 80x*) zooms=4 ;; 40x*) zooms=8 ;; esac
  case $picture in *x240) zooms="$zooms 1" ;; *x120) zooms="$zooms 2" ;; *x60) zooms="$zooms 4" ;; *x30) zooms="$zooms 8" ;; *) zooms= ;; esac
  case $zooms in [1248]" "[1248]) ;; *) wrong_usage "--picture takes a width of 320, 160, 80 or 40 and a height of 240, 120, 60 or 30, such as 160x120, not '$picture'" ;; esac
}
