#!/usr/bin/env bash
# The real i686 programs of ./dev build --robot, on a virtual robot behind the serial device.
. "$(dirname "$(readlink -f "$0")")/robot.sh"

# The newest real bundle; unlike everywhere else this test cannot make its own.
real_bundle() {
  local newest
  # shellcheck disable=SC2012  # names of ours
  newest=$(ls -t "$SOURCE"/build/robot/darwinop-*-i686.tar.gz 2>/dev/null | head -n 1)
  [ -n "$newest" ] || fail "there is no build/robot/darwinop-*-i686.tar.gz; run: ./dev build --robot"
  echo "$newest"
}

program_says() { chroot "$ROBOT" /opt/darwinop/current/bin/darwinop --version >/dev/null && cat "$ROBOT/opt/darwinop/current/VERSION"; }

scenario_install_boot_and_uninstall() {
  local bundle version tries=0; bundle=$(real_bundle)
  version=$(tar -xzOf "$bundle" VERSION)
  plug_virtual_robot
  remember_disk
  run_install --bundle "$bundle"
  expect_status 0
  expect_version "$version"
  expect_confirmed
  grep -q '^======== libespeak-ng-dev ' "$ROBOT/opt/darwinop/current/NOTICE" || fail "the licences did not come along"
  grep -q 'pkg:deb/debian/libinih-dev@' "$ROBOT/opt/darwinop/current/sbom.cdx.json" || fail "the list of packages did not come along"
  robot_boot 0
  until chroot "$ROBOT" /opt/darwinop/current/bin/darwinop-runtime --status >"$LAB/runtime_status" 2>&1; do
    [ $((tries += 1)) -lt 40 ] || fail "no runtime came up at boot: $(cat "$LAB/runtime_status" "$ROBOT"/opt/darwinop/log/*)"
    sleep 0.25
  done
  run_install --status
  expect_status 0
  expect_said "$(printf '%s' "$version" | sed 's/[+.]/\\&/g')"
  run_install --uninstall
  expect_status 0
  robot_quiet
  [ -z "$(pgrep -f 'darwinop-(runtime|supervisor)' || true)" ] || fail "the runtime still runs after uninstall"
  expect_same_disk "uninstall did not bring the disk back"
}

scenario_a_robot_without_a_servo_is_not_confirmed() {
  local bundle; bundle=$(real_bundle)
  rm "$ROBOT/dev/ttyUSB0"
  ln -s zero "$ROBOT/dev/ttyUSB0"  # a device that is not a CM-730
  run_install --bundle "$bundle"
  expect_status 1 4
  expect_version none
}

run_scenarios "$@"
