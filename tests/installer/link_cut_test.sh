#!/usr/bin/env bash
# The connection is lost after a number of bytes: afterwards one complete version runs, and a rerun completes.
. "$(dirname "$(readlink -f "$0")")/robot.sh"
# shellcheck source=robot_torture.sh
. "$HERE/robot_torture.sh"

install_over_cut_link() {
  run_install -i "$LAB/pc/key" -o "ProxyCommand=$HERE/cut_link.sh $1 %h %p ${2:-/dev/null}" --bundle "$new_bundle"
}

# cut_points COUNT FIRST STEP: the FIRST-th, then every STEP-th of COUNT points over the whole conversation. Of these one
# in $every, after the first $skip.
cut_points() {
  local count=$1 point=$(($2 + $3 * skip)) step=$(($3 * every)) total bytes
  rm -f "$LAB/sent"
  install_over_cut_link 1000000000 "$LAB/sent"
  expect_status 0
  total=$(stat -c %s "$LAB/sent")
  for (( ; point <= count; point += step)); do
    robot_restore
    bytes=$((total * point / count - 17))
    install_over_cut_link $bytes
    [ "$status" != 0 ] || [ "$point" = "$count" ] || fail "cut after $bytes of $total bytes: the installer reported success"
    [ "$status" -lt 124 ] || fail "cut after $bytes of $total bytes: the installer did not end ($status)"
    after_break "cut after $bytes of $total bytes"
  done
}

scenario_upgrade_cut_at_odd_points() { begin_with "$(fake_bundle 0.1.0+a 300)" "$(fake_bundle 0.2.0+b 300)"; cut_points 30 1 2; }
scenario_upgrade_cut_at_even_points() { begin_with "$(fake_bundle 0.1.0+a 300)" "$(fake_bundle 0.2.0+b 300)"; cut_points 30 2 2; }
scenario_fresh_robot_cut() { begin_with none "$(fake_bundle 0.2.0+b 300)"; cut_points 15 1 1; }

# The archive is most of what is sent, so points over all bytes say little about what comes after it.
scenario_upgrade_cut_after_the_archive() {
  local total bytes back
  begin_with "$(fake_bundle 0.1.0+a)" "$(fake_bundle 0.2.0+b)"
  rm -f "$LAB/sent"
  install_over_cut_link 1000000000 "$LAB/sent"
  total=$(stat -c %s "$LAB/sent")
  for back in 1 40 100 200 400 1000 3000; do
    robot_restore
    bytes=$((total - back))
    install_over_cut_link $bytes
    [ "$status" -lt 124 ] || fail "cut $back bytes before the end: the installer did not end ($status)"
    after_break "cut $back bytes before the end"
  done
}

scenario_stop_says_that_the_connection_was_lost() {
  begin_with "$(fake_bundle 0.1.0+a)" "$(fake_bundle 0.2.0+b)"
  rm -f "$LAB/sent"
  run_install -i "$LAB/pc/key" -o "ProxyCommand=$HERE/cut_link.sh 1000000000 %h %p $LAB/sent" --stop
  expect_status 0
  run_install -i "$LAB/pc/key" -o "ProxyCommand=$HERE/cut_link.sh $(($(stat -c %s "$LAB/sent") / 2)) %h %p /dev/null" --stop
  expect_status 1
  expect_said "$msg_robot_lost"
}

# The robot has not noticed yet that the first one is cut: the second waits its turn, and nothing is taken from under it.
scenario_again_at_once_on_a_fresh_robot() {
  local round
  begin_with none "$(fake_bundle 0.2.0+b 300)"
  rm "$ROBOT/bin/rm"  # a slow end of tidying up, so that the second comes in between
  printf '#!/bin/sh\ncase "$*" in "-rf /opt/darwinop" | "-rf /opt/darwinop/kept") sleep 2 ;; esac\nexec /.host/bin/rm "$@"\n' >"$ROBOT/bin/rm"
  chmod 755 "$ROBOT/bin/rm"
  for round in 1 2; do
    robot_restore
    install_over_cut_link 200000
    run_install -i "$LAB/pc/key" --bundle "$new_bundle"
    if [ "$status" = 5 ]; then robot_quiet; run_install -i "$LAB/pc/key" --bundle "$new_bundle"; fi
    [ "$status" = 0 ] || fail "round $round: the second install ended with $status"
    robot_quiet
    settled_disk | grep -v 'bin/rm\b' >"$LAB/disk_now"
    grep -v 'bin/rm\b' "$LAB/disk_wanted" | cmp -s - "$LAB/disk_now" ||
      fail "round $round: the disk is not that of an undisturbed install: $(diff "$LAB/disk_wanted" "$LAB/disk_now" | head)"
  done
}

run_scenarios "$@"
