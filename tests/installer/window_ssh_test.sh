#!/usr/bin/env bash
# darwinop window --robot tcp://USER@HOST: looks through a real monitor on the robot and drives it, through a real sshd.
# shellcheck disable=SC2034,SC2154  # remote_lab.sh and robot.sh set and read what is set and read here
. "$(dirname "$(readlink -f "$0")")/remote_lab.sh"

# start_window [OPTIONS]: as start_run. Sets $url once it can be opened.
start_window() {
  : >"$LAB/out"
  env --default-signal=INT DARWINOP_PASSWORD="$password" setsid "${run%-run}-window" --robot "tcp://$login@$ADDRESS" "$@" \
    </dev/null >>"$LAB/out" 2>&1 &
  run_pid=$!
}

open_page() {
  await 'http://'
  url=$(grep -o 'http://[^ ]*' "$LAB/out" | head -1)
}

# page NAME CHANNEL WORDS...: a page that runs until page_gone; received messages are in $LAB/NAME.
page() {
  "$HERE/window_page.sh" "$url" "${@:2}" >"$LAB/$1" 2>"$LAB/$1.errors" &
  eval "${1}_pid=$!"
}
page_gone() { kill "$(eval "echo \$${1}_pid")" 2>/dev/null || true; }

# await_page NAME PATTERN
await_page() {
  local tries=0
  until grep -qaE -- "$2" "$LAB/$1"; do
    [ $((tries += 1)) -lt 500 ] || fail "the page did not receive '$2': $(tail -c 600 "$LAB/$1" | tr -d '\0')$(cat "$LAB/out")"
    sleep 0.02
  done
}

# await_neck MILLIRAD: waits until an observing page shows the neck beyond this angle.
await_neck() {
  local tries=0
  until grep -ao '"position":\[[^]]*' "$LAB/eyes" | tail -n 1 | awk -F, -v least="$1" '$19 * 1000 > least { ok = 1 } END { exit !ok }'; do
    [ $((tries += 1)) -lt 500 ] || fail "the neck did not move: $(grep -ao '"position":\[[^]]*' "$LAB/eyes" | tail -n 1)"
    sleep 0.02
  done
}

scenario_a_window_looks_on_drives_and_ends() {
  robot_with_a_runtime
  start_window
  open_page
  expect_said 'connected to darwin@127.0.0.1 \([0-9.]+ s\)$'
  expect_said "$msg_ready"
  # Only on loopback, on both sides; nobody drives, and nobody is kept from it.
  ! ss -Hltn 2>/dev/null | awk '{ print $4 }' | grep -vE '^(127\.0\.0\.1|\[::1\]):' || fail "a port is open to the network"
  page eyes monitor '{"rate":62.5}'
  await_page eyes '"state":"limp"'
  expect_user 998 '^[^ ]*darwinop-(remote|monitor) '
  ! runtime_says | grep '^driver  *pid' >/dev/null || fail "a window that looks on drives"
  [ ! -e "$ROBOT/opt/darwinop/running" ] || fail "a window that looks on keeps others out"
  page form transfer '{"more":0}'
  await_page form '"given":\{"address":"127.0.0.1","key":"","port":0,"user":"darwin"\}'
  page_gone form
  page hand steering '{"take":true}' '{"goals":{"Neck":0.5}}'
  await_page hand '"yours":true'
  await_neck 300
  page_gone hand
  tries=0
  until ! runtime_says | grep '^driver  *pid' >/dev/null; do [ $((tries += 1)) -lt 200 ] || fail "the lease is not given back"; sleep 0.05; done
  kill -INT -- "-$run_pid"
  wait_run
  expect_status 0
  expect_last_line "robot: ($msg_limp|$msg_state_unknown)"  # a busy machine starves its board
  expect_limp
  page_gone eyes
}

# The window observes, steering names the driver, and a driving window ends normally even when it is killed.
scenario_somebody_else_drives_then_the_window_and_it_is_killed() {
  robot_with_a_runtime
  chroot "$ROBOT" /opt/darwinop/start </dev/null >/dev/null 2>&1 &
  until runtime_says >/dev/null 2>&1; do sleep 0.05; done
  chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-remote --robot runtime --port 5999 >"$LAB/theirs" 2>&1 &
  local theirs=$! client_pid
  until grep -qs ready "$LAB/theirs"; do sleep 0.02; done
  DARWINOP_ROBOT=tcp://127.0.0.1:5999 "$client" >"$LAB/their-client" 2>&1 &
  client_pid=$!
  until grep -qs driving "$LAB/their-client"; do sleep 0.02; done
  start_window
  open_page
  expect_said "darwinop-remote \(process [0-9]+\) .* darwinop install --stop"
  page eyes monitor '{"rate":62.5}'
  await_page eyes '"state":"driven"'
  page hand steering '{"take":true}' '{}'
  await_page hand '\(pid [0-9]+\)'
  page_gone hand
  kill "$theirs" "$client_pid"
  wait "$theirs" "$client_pid" || true
  page hand steering '{"take":true}' '{"goals":{"Neck":0.5}}'
  await_page hand '"yours":true'
  kill -KILL "$run_pid"
  wait_run
  expect_limp
}

# A start would take back what is being tried. And a window whose monitor has ended shows nothing: it ends also.
scenario_a_window_starts_nothing_while_somebody_installs_and_ends_with_its_monitor() {
  robot_with_a_runtime
  sleep 300 &
  local installing=$!
  echo "$installing $(chroot "$ROBOT" cat /proc/sys/kernel/random/boot_id) $(cut -d ' ' -f 22 "/proc/$installing/stat")" >"$ROBOT/opt/darwinop/lock"
  echo - >"$ROBOT/opt/darwinop/pending"
  start_window
  open_page
  expect_said "$msg_other_install \(process $installing\)"
  expect_said "$msg_no_start"
  [ "$(readlink "$ROBOT/opt/darwinop/current") $(cat "$ROBOT/opt/darwinop/pending")" = 'versions/real -' ] || fail "the version that is tried was taken back"
  [ -s "$ROBOT/opt/darwinop/lock" ] || fail "the lock of another one is gone"
  ! supervisor_says >/dev/null 2>&1 || fail "a supervisor was started"
  pkill -f '/darwinop-monitor --end-with-parent'
  wait_run
  expect_status 1
  expect_said 'robot: the monitor has ended'
  kill "$installing"
}

# An operator can end any driver, including a window; a lost connection and a robot without monitor are reported.
scenario_the_end_of_a_window_is_reported() {
  robot_with_a_runtime
  start_window
  open_page
  page hand steering '{"take":true}' '{"goals":{"Neck":0.5}}'
  await_page hand '"yours":true'
  page eyes monitor '{"rate":20}'
  cp "$LAB/out" "$LAB/first"
  if DARWINOP_PASSWORD=$password "$run" --robot "tcp://$login@$ADDRESS" "$client" </dev/null >"$LAB/out" 2>&1; then fail "two drive"; fi
  expect_said "$msg_driven_from_window"
  run_install --stop
  expect_status 0
  expect_said "$msg_window_stopped"
  cp "$LAB/first" "$LAB/out"
  wait_run
  expect_status 1
  grep -qa 'darwin@127.0.0.1' "$LAB/eyes" || fail "the page got no message"
  expect_limp
  start_window
  open_page
  page eyes monitor '{"rate":20}'
  await_page eyes '"state":"'
  kill -KILL "$(master_of_ssh)"
  wait_run
  expect_status 1
  expect_said "$login@$ADDRESS $msg_lost, .*$msg_if_driven"
  grep -qa 'darwin@127.0.0.1' "$LAB/eyes" || fail "the page got no message"
  rm "$ROBOT/opt/darwinop/current/bin/darwinop-monitor"
  start_window
  wait_run
  expect_status 1
  expect_said 'version real on this robot has no monitor for the window; upgrade it first: darwinop install'
}

run_scenarios "$@"
