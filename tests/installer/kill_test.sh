#!/usr/bin/env bash
# kill -9 of the robot's side before every command between "# >>> transaction" and "# <<< transaction" of
# installer/robot/*.sh, during the transfer, and of /opt/darwinop/start: afterwards one complete version runs, and a rerun
# completes.
. "$(dirname "$(readlink -f "$0")")/robot.sh"
# shellcheck source=robot_torture.sh
. "$HERE/robot_torture.sh"

# transaction_lines: FILE:LINE of every command between the markers, and in `stage`, which takes the archive in, before
# which a command may stand.
transaction_lines() {
  local place
  awk '
    FNR == 1 { inside = 0 }
    /# >>> transaction/ { inside = 1; next }
    /^stage\(\)/ { inside = 1; next }
    /# <<< transaction/ || /^}/ { inside = 0 }
    inside && !/^[ \t]*(#|$)/ { print FILENAME ":" FNR }
  ' "$SOURCE"/installer/robot/*.sh | while IFS= read -r place; do
    if sed "${place##*:}i :" "${place%:*}" | dash -n 2>/dev/null; then echo "$place"; fi
  done
}

# changed_installer COMMAND PLACE...: a copy with COMMAND inserted before these places; @ in it is FILE:LINE.
changed_installer() {
  local command=$1 copy=$LAB/changed file line place
  shift
  rm -rf "$copy"
  mkdir "$copy"
  cp -r "$SOURCE/installer" "$SOURCE/rc.local.template" "$copy/"
  # Last lines first, so that the line numbers stay valid.
  printf '%s\n' "$@" | sort -t: -k1,1 -k2,2nr | while IFS= read -r place; do
    file=$(basename "${place%:*}") line=${place##*:}
    sed -i "${line}i ${command//@/$file:$line}" "$copy/installer/robot/$file"
  done
  dash -n "$copy"/installer/robot/*.sh
}
run_changed() { installer=$LAB/changed/installer/darwinop-install run_install -i "$LAB/pc/key" "$@"; }

# find_places ARGS...: sets $places to those that an installer with these arguments comes by.
find_places() {
  local all=()
  mapfile -t all < <(transaction_lines)
  [ ${#all[@]} -gt 20 ] || fail "there is hardly a command between the markers in installer/robot"
  changed_installer 'echo @ >>/run/places' "${all[@]}"
  rm -f "$ROBOT/run/places"
  run_changed "$@"
  robot_quiet
  robot_restore
  mapfile -t places < <(awk '!seen[$0]++' "$ROBOT/run/places")
  [ ${#places[@]} -gt 5 ] || fail "the installer hardly came by a command between the markers"
}

# kill_at PLACES_FIRST STEP CHECK ARGS...: dies at every STEP-th of $places; CHECK gets the name of the place. Of these
# one in $every, after the first $skip.
kill_at() {
  local number=$(($1 + $2 * skip)) step=$(($2 * every)) check=$3 died=0
  shift 3
  for (( ; number < ${#places[@]}; number += step)); do
    robot_restore
    changed_installer 'kill -9 $$' "${places[number]}"
    run_changed "$@"
    [ "$status" != 0 ] || fail "the test did not kill before ${places[number]}"
    [ "$status" -lt 124 ] || fail "killed before ${places[number]}: the installer did not end ($status)"
    died=$((died + 1))
    "$check" "killed before ${places[number]}"
  done
  [ $died -gt 0 ] || fail "of ${#places[@]} places none was tried"
  echo "killed at $died of ${#places[@]} places"
}

upgrade_killed() {
  begin_with "$(fake_bundle 0.1.0+a 50)" "$(fake_bundle 0.2.0+b 50)"
  find_places --bundle "$new_bundle"
  kill_at "$1" 2 after_break --bundle "$new_bundle"
}
scenario_upgrade_killed_at_odd_places() { upgrade_killed 0; }
scenario_upgrade_killed_at_even_places() { upgrade_killed 1; }

fresh_install_killed() {
  begin_with none "$(fake_bundle 0.2.0+b 50)"
  find_places --bundle "$new_bundle"
  kill_at "$1" 2 after_break --bundle "$new_bundle"
}
scenario_fresh_install_killed_at_odd_places() { fresh_install_killed 0; }
scenario_fresh_install_killed_at_even_places() { fresh_install_killed 1; }

# Confirmed, but not yet in the autostart: the next boot has started the demo.
scenario_an_installation_that_is_completed_ends_the_demo() { completed_ends /darwin/Linux/project/demo/demo; }
scenario_an_installation_that_is_completed_ends_a_default_controller_of_webots() {
  completed_ends /robotis/Linux/project/webots/default
}
completed_ends() { # PROGRAM on the robot that uses the port without a lock
  local v1 process; v1=$(fake_bundle 0.1.0+a)
  login=robotis
  changed_installer 'kill -9 $$' "switch.sh:$(grep -n '  autostart_set ' "$SOURCE/installer/robot/switch.sh" | cut -d: -f1)"
  run_changed --bundle "$v1"
  robot_quiet
  expect_version 0.1.0+a
  expect_confirmed
  mkdir -p "$ROBOT${1%/*}"
  rm -f "$ROBOT$1"
  cp /usr/bin/sleep "$ROBOT$1"
  chroot "$ROBOT" "$1" 300 &
  process=$!
  run_install -i "$LAB/pc/key" --bundle "$v1"
  expect_status 0
  ! kill -0 "$process" 2>/dev/null || fail "$1 goes on beside the runtime"
}

# A failed self-test reverts the version, which must be equally safe.
after_failed_self_test() {
  rm "$ROBOT/run/fail-self-test"
  after_break "$1"
  echo 0.2.0+b >"$ROBOT/run/fail-self-test"
}
scenario_going_back_killed() {
  begin_with "$(fake_bundle 0.1.0+a 50)" "$(fake_bundle 0.2.0+b 50)"
  echo 0.2.0+b >"$ROBOT/run/fail-self-test"
  find_places --bundle "$new_bundle"
  kill_at $((${#places[@]} / 2)) 1 after_failed_self_test --bundle "$new_bundle"
}

# Half an uninstall may still start the version or not; run again, it ends with the disk of before.
after_killed_uninstall() {
  local now
  robot_quiet
  robot_boot 5
  now=$(version_now)
  case $now in none | "$old") ;; *) fail "$1: on the robot is: $now" ;; esac
  run_install -i "$LAB/pc/key" --uninstall
  [ "$status" = 0 ] || fail "$1: uninstall, run again, ended with $status"
  robot_quiet
  expect_same_disk "$1: uninstall, run again, did not bring the disk back"
}
scenario_uninstall_killed() {
  login=robotis
  remember_disk
  run_install -i "$LAB/pc/key" --bundle "$(fake_bundle 0.1.0+a)"
  old=$(version_now)
  robot_quiet
  robot_save
  find_places --uninstall
  kill_at 0 1 after_killed_uninstall --uninstall
}

# Power failure while `start` reverts an unconfirmed version.
scenario_start_killed_at_boot() {
  local start=$ROBOT/opt/darwinop/start line lines
  begin_with "$(fake_bundle 0.1.0+a)" "$(fake_bundle 0.2.0+b)"
  hold_in_self_test
  robot_save
  lines=$(wc -l <"$start")
  for ((line = 2; line <= lines; line++)); do
    robot_restore
    sed "${line}i kill -9 \$\$" "$start" >"$LAB/deadly_start"
    dash -n "$LAB/deadly_start" 2>/dev/null || continue
    cp -p "$start" "$LAB/start"
    cat "$LAB/deadly_start" >"$start"
    robot_boot 5
    cp -p "$LAB/start" "$start"
    robot_boot
    [ "$booted" = "$old" ] || fail "start killed before line $line, then a boot: up came ${booted:-nothing}"
    [ "$(version_now)" = "$old" ] || fail "start killed before line $line: on the robot is $(version_now)"
    expect_confirmed
  done
}

# An upgrade interrupted in its self-test: the new version is current and pending.
hold_in_self_test() {
  local tries=0
  : >"$ROBOT/run/hold-self-test"
  rm -f "$ROBOT/run/self-test-begun"
  (run_install -i "$LAB/pc/key" --bundle "$new_bundle") &
  until [ -e "$ROBOT/run/self-test-begun" ]; do
    [ $((tries += 1)) -lt 500 ] || fail "the install did not come to its self-test"
    sleep 0.02
  done
  robot_kill_sessions
  wait $! || true
  rm "$ROBOT/run/hold-self-test"
  [ "$(version_now)" = "$new" ] || fail "the test did not come to an unconfirmed version"
}

run_scenarios "$@"
