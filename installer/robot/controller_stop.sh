# shellcheck shell=sh
# Ends what drives the robot: a controller that was sent, the window, a program started on the robot itself.

end_s=10  # to end after SIGINT: a step, the controller's cleanup, the end of the session

# stop_process PID: of darwinop-run. SIGINT, then SIGINT again, then SIGKILL to it and its children.
stop_process() {
  kill -INT "$1" 2>/dev/null
  ended_within $end_s "$1" && return
  say "the controller does not end; killing it"
  kill -INT "$1" 2>/dev/null  # the second one ends programs of our library at once
  ended_within 3 "$1" && return
  for stat in /proc/[0-9]*/stat; do
    # Field 4 is the parent; the name in field 2 may contain any character.
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
  # Not started yet: nothing to stop.
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
  say "$name stopped"
}

# That of the runtime; or without one a program that has the serial port: a controller that hosts its own loop. Not a
# runtime that starts, nor a supervisor that brings the robot to rest.
# shellcheck disable=SC2012  # names under /proc are numbers
other_driver() {
  if daemon_ready; then
    robot_driver
    return
  fi
  for process in $(ls -l /proc/[0-9]*/fd 2>/dev/null | awk -v port=" -> $(readlink -f "$(robot_port)")" '
    /^\/proc\// { split($0, part, "/"); process = part[3] }
    substr($0, length($0) - length(port) + 1) == port { print process }'); do
    case $(cat "/proc/$process/comm" 2>/dev/null) in
      darwinop-runtim* | darwinop-superv*) ;;
      *) echo "$process"; return ;;
    esac
  done
}

# What drives and the other steps do not handle.
stop_other_driver() {
  driver=$(other_driver)
  [ -n "$driver" ] || return 0
  name=$(cat "/proc/$driver/comm" 2>/dev/null)
  stop_process "$driver"
  driver=$(other_driver)
  [ -z "$driver" ] || die "$(cat "/proc/$driver/comm" 2>/dev/null) (process $driver) $msg_still_drives: sudo kill -INT $driver (on the robot), or hold the robot and press MODE briefly"
  say "$name $msg_other_stopped"
}
