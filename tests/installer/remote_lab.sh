# shellcheck shell=bash disable=SC2034,SC2154  # some names are read by the scenarios, others set by robot.sh
# For the scenarios of remote control: darwinop run on this PC, a real runtime on the robot. Sourced by remote_test.sh.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/robot.sh"
# shellcheck source=real_runtime.sh
. "$HERE/real_runtime.sh"

run=${DARWINOP_BIN:-$SOURCE/build/debug/bin}/darwinop-run
client=$HERE/remote_client.sh

robot_with_a_runtime() {
  put_real_runtime
  plug_virtual_robot
}

# start_run [OPTIONS]: as in a terminal of its own: a process group that gets Ctrl-C.
start_run() {
  : >"$LAB/out"
  env --default-signal=INT DARWINOP_PASSWORD="$password" setsid "$run" --robot "tcp://$login@$ADDRESS" "$@" "$client" \
    </dev/null >>"$LAB/out" 2>&1 &
  run_pid=$!
}

# wait_run [SECONDS]: sets $status. Nothing may be left, neither here nor on the robot.
wait_run() {
  local tries=0
  while kill -0 "$run_pid" 2>/dev/null; do
    [ $((tries += 1)) -lt $((${1:-30} * 50)) ] || fail "darwinop run does not end: $(cat "$LAB/out"; ps -eo pid,ppid,stat,args | cut -c -150)"
    sleep 0.02
  done
  status=0
  wait "$run_pid" || status=$?
  { cat "$LAB/out"; echo "exit code $status"; } >>"$LAB/history"
  robot_quiet
  expect_pc_quiet
}

expect_pc_quiet() {
  local tries=0
  while pgrep -x ssh >/dev/null; do
    [ $((tries += 1)) -lt 250 ] || fail "ssh still runs on the PC: $(pgrep -ax ssh | cut -c -200)"
    sleep 0.02
  done
}

# await PATTERN [SECONDS]
await() {
  local tries=0
  until grep -qE -- "$1" "$LAB/out"; do
    [ $((tries += 1)) -lt $((${2:-20} * 50)) ] || fail "'$1' was not said: $(cat "$LAB/out")"
    kill -0 "$run_pid" 2>/dev/null || grep -qE -- "$1" "$LAB/out" || fail "it ended without '$1': $(cat "$LAB/out")"
    sleep 0.02
  done
}

expect_limp() {
  local tries=0
  until runtime_says | grep '^state .*limp' >/dev/null; do
    [ $((tries += 1)) -lt 400 ] || fail "the robot was not brought to rest: $(runtime_says)"
    sleep 0.02
  done
}
expect_last_line() { tail -n "${2:-1}" "$LAB/out" | grep -qE -- "$1" || fail "the last line is not '$1': $(tail -n 3 "$LAB/out")"; }

# on_terminal "PATTERN=KEYS"... -- [OPTIONS]: with a person at a terminal, who waits for each pattern and types.
on_terminal() {
  local steps=() step
  while [ "$1" != -- ]; do steps+=("$1"); shift; done
  shift
  rm -f "$LAB/keyboard"
  mkfifo "$LAB/keyboard"
  exec 7<>"$LAB/keyboard"
  : >"$LAB/out"
  printf '%q ' exec env --default-signal=INT -u DARWINOP_PASSWORD "$run" --robot "tcp://$login@$ADDRESS" "$@" "$client" >"$LAB/command"
  script -qefc "$(cat "$LAB/command")" /dev/null <&7 >>"$LAB/out" 2>&1 &
  run_pid=$!
  for step in "Password of=$password\n" "${steps[@]}"; do
    await "${step%%=*}"
    sleep 0.1  # it switches the echo off after the question
    printf '%b' "${step#*=}" >&7
  done
  wait_run
  exec 7>&-
}

# The robot does not sit as it should for as long as /run/pose-unsafe is there.
make_pose_a_matter_of_a_file() {
  local bin=$ROBOT/opt/darwinop/current/bin
  mkdir "$bin/real"
  mv "$bin/darwinop-runtime" "$bin/real"
  cat >"$bin/darwinop-runtime" <<'END'
#!/bin/sh
case " $* " in *--check-pose*) if [ -e /run/pose-unsafe ]; then cat /run/pose-unsafe; exit 3; fi ;; esac
exec /opt/darwinop/current/bin/real/darwinop-runtime "$@"
END
  chmod 755 "$bin/darwinop-runtime"
  echo 'KneeR is 0.8 rad off' >"$ROBOT/run/pose-unsafe"
}

# Kills -9 all shells on the robot that run a program of the installer, so that none of them can see to the others.
kill_shells() {
  local process shells=()
  for process in $(robot_processes --foreign); do
    case $({ tr '\0' ' ' <"/proc/$process/cmdline"; } 2>/dev/null || true) in "sh -c "*darwinop-program*) shells+=("$process") ;; esac
  done
  kill -KILL "${shells[@]}"
}

master_of_ssh() { pgrep -f '^ssh .* -M .*-N' | head -1; }
