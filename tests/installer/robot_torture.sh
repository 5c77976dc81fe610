# shellcheck shell=bash disable=SC2034,SC2154  # variables of robot.sh
# For tests that break an install at many points: the state before, the one wanted after, and the checks between.
# Sourced by the tests that need it. They set $old (version or none), $new and $new_bundle.

# A break takes two seconds. One in five is tried; which, follows from the seed. DARWINOP_EVERY=1 tries all.
every=${DARWINOP_EVERY:-5}
seed=${DARWINOP_SEED:-2026}
skip=$((seed % every))
echo "one break in $every, after the first $skip: DARWINOP_EVERY=$every DARWINOP_SEED=$seed"

# Without the log, which may differ, and the lock's traces in memory.
settled_disk() { robot_disk | grep -v ' opt/darwinop/log/\|^\./opt/darwinop/log/'; }

# begin_with BUNDLE|none NEW_BUNDLE: the robot before each break is saved, the undisturbed result is noted.
begin_with() {
  old=none
  new_bundle=$2
  login=robotis
  if [ "$1" != none ]; then
    run_install -i "$LAB/pc/key" --bundle "$1"
    expect_status 0
    old=$(version_now)
  fi
  robot_quiet
  robot_save
  run_install -i "$LAB/pc/key" --bundle "$new_bundle"
  expect_status 0
  new=$(version_now)
  robot_quiet
  settled_disk >"$LAB/disk_wanted"
  robot_restore
  [ "$(version_now)" = "$old" ] || fail "the test could not bring the robot back to $old"
}

# after_break WHERE: one of both versions is whole and comes up at boot; the plain installer then completes.
after_break() {
  local now boot_ticks=100
  robot_quiet
  now=$(version_now)
  case $now in "$old" | "$new") ;; *) fail "$1: on the robot is: $now" ;; esac
  # A first version may lie there unconfirmed; then nothing of ours comes up.
  if [ "$old" = none ] && ! grep -q '/opt/darwinop/start' "$ROBOT/etc/rc.local"; then boot_ticks=5; fi
  robot_boot $boot_ticks
  now=$(version_now)
  case $now in "$old" | "$new") ;; *) fail "$1, then a boot: on the robot is: $now" ;; esac
  case ${booted:-none} in "$now" | "$old") ;; *) fail "$1, then a boot: up came $booted, but current is $now" ;; esac
  if [ "$old" != none ] && [ "$booted" != "$now" ]; then fail "$1, then a boot: up came ${booted:-nothing}"; fi
  [ -z "$booted" ] || expect_no_demo
  run_install -i "$LAB/pc/key" --bundle "$new_bundle"
  [ "$status" = 0 ] || fail "$1: the installer, run again, ended with $status"
  now=$(version_now)
  [ "$now" = "$new" ] || fail "$1: run again, on the robot is: $now"
  expect_confirmed
  robot_quiet
  settled_disk >"$LAB/disk_now"
  cmp -s "$LAB/disk_wanted" "$LAB/disk_now" ||
    fail "$1: run again, the disk is not that of an undisturbed install: $(diff "$LAB/disk_wanted" "$LAB/disk_now" | head)"
}
