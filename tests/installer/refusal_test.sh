#!/usr/bin/env bash
# What the installer refuses or takes back: full disks, wrong machines, broken bundles, failed self-tests, two at once.
. "$(dirname "$(readlink -f "$0")")/robot.sh"

limit_disk() { mount -t tmpfs -o "size=$1,mode=755" disk "$ROBOT/opt"; }

scenario_disk_full_is_seen_before_any_change() {
  local v1; v1=$(fake_bundle 0.1.0+a 800)
  limit_disk 400k
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 1
  expect_said '/opt .* [0-9]+ kB .* [0-9]+ kB'
  expect_not_said 'sending'
  robot_quiet
  expect_same_disk --touched "a robot without room was changed"
}

scenario_what_a_power_cut_left_counts_as_free() {
  local v1; v1=$(fake_bundle 0.1.0+a 800)
  limit_disk 3500k
  mkdir -p "$ROBOT/opt/darwinop/versions/.staging-99"
  head -c 1500k /dev/zero >"$ROBOT/opt/darwinop/versions/.staging-99/archive.tar.gz"
  run_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  [ ! -e "$ROBOT/opt/darwinop/versions/.staging-99" ] || fail "what the power cut left is still there"
}

scenario_a_complete_version_needs_no_more_room() {
  local v1; v1=$(fake_bundle 0.1.0+a 800)
  limit_disk 3500k
  run_install --bundle "$v1"
  expect_status 0
  head -c 2200k /dev/zero >"$ROBOT/opt/recording.csv"
  run_install --bundle "$v1"
  expect_status 0
  expect_said "$msg_nothing_to_do"
  run_install --autostart none --bundle "$v1"
  expect_status 0
}

# Somebody else fills the disk after the check: df says what is not so.
lying_df() {
  rm "$ROBOT/bin/df"
  printf '%s\n' '#!/bin/sh' 'echo "Filesystem 1024-blocks Used Available Capacity Mounted on"' \
    'echo "/dev/sda1 3000000 1000000 2000000 34% /"' >"$ROBOT/bin/df"
  chmod 755 "$ROBOT/bin/df"
}

scenario_disk_runs_full_while_unpacking() {
  local v1; v1=$(fake_bundle 0.1.0+a 800)
  limit_disk 400k
  lying_df
  run_install --bundle "$v1"
  expect_status 1
  expect_version none
  umount "$ROBOT/opt"
  run_install --bundle "$v1"
  expect_status 0
  expect_boots 0.1.0+a
}

scenario_disk_runs_full_during_an_upgrade() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a 100); v2=$(fake_bundle 0.2.0+b 800)
  limit_disk 700k
  run_install --bundle "$v1"
  expect_status 0
  lying_df
  robot_quiet
  remember_disk
  run_install --bundle "$v2"
  expect_status 1
  expect_version 0.1.0+a
  robot_quiet
  expect_same_disk "the failed upgrade left something behind"
  expect_boots 0.1.0+a
  mount -o remount,size=3m "$ROBOT/opt"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_all_problems_of_the_machine_are_reported_together() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  local flags; flags=$(sed 's/ ssse3//' "$LAB/cpuinfo")
  echo "$flags" >"$LAB/cpuinfo"
  ! grep -q ssse3 "$ROBOT/proc/cpuinfo" || fail "the test did not take ssse3 from the processor"
  echo 2.6.18-6-686 >"$ROBOT/run/kernel"
  rm "$ROBOT/dev/ttyUSB0"
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 1
  expect_said 'ssse3|SSSE3'
  expect_said '2\.6\.18'
  expect_said '/dev/ttyUSB0'
  robot_quiet
  expect_same_disk --touched "a robot that cannot run it was changed"
}

scenario_without_robot_leaves_device_and_self_test_out() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  rm "$ROBOT/dev/ttyUSB0"
  run_install --bundle "$v1"
  expect_status 1
  expect_said '--without-robot'
  run_install --without-robot --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  [ ! -e "$ROBOT/run/doctor-calls" ] || fail "a self-test was run without a robot"
  expect_boots 0.1.0+a
}

scenario_port_goes_into_a_new_robot_ini() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  mv "$ROBOT/dev/ttyUSB0" "$ROBOT/dev/ttyUSB3"
  run_install --port /dev/ttyUSB3 --bundle "$v1"
  expect_status 0
  grep -qE '^port *= */dev/ttyUSB3' "$ROBOT/opt/darwinop/robot.ini" || fail "robot.ini does not name the port"
}

scenario_port_that_an_existing_robot_ini_contradicts_is_refused() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a) v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  run_install --port /dev/ttyUSB0 --bundle "$v2" --dry-run
  expect_status 0
  remember_disk --touched
  run_install --port /dev/ttyUSB3 --bundle "$v2"
  expect_status 1
  expect_said 'robot.ini names the port /dev/ttyUSB0 and is kept'
  expect_same_disk --touched "a port that cannot be had changed something"
  mv "$ROBOT/dev/ttyUSB0" "$ROBOT/dev/ttyUSB3"
  run_install --bundle "$v2"
  expect_status 1
  expect_said 'has to be named in /opt/darwinop/robot.ini'
}

scenario_port_of_robot_ini_is_read_as_the_programs_read_it() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install --bundle "$v1"
  printf '[Safety]\nport = /dev/wrong\n [ROBOT]\r\n Port : "/dev/ttyUSB7"  # the other one\r\n' >"$ROBOT/opt/darwinop/robot.ini"
  run_install --status
  expect_said 'port: +/dev/ttyUSB7$'
}

scenario_failed_self_test_on_a_fresh_robot() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  : >"$ROBOT/run/fail-self-test"
  remember_disk
  run_install --bundle "$v1"
  expect_status 1
  expect_said 'servo 11'
  robot_quiet
  expect_same_disk "a first version that failed its self-test left something behind"
  expect_boots_nothing_of_ours
  rm "$ROBOT/run/fail-self-test"
  run_install --bundle "$v1"
  expect_status 0
  expect_boots 0.1.0+a
}

scenario_failed_self_test_brings_the_previous_version_back() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  echo 0.2.0+b >"$ROBOT/run/fail-self-test"
  run_install --bundle "$v2"
  expect_status 4
  expect_said 'servo 11'
  expect_said '0\.1\.0\+a'
  expect_version 0.1.0+a
  expect_confirmed
  expect_boots 0.1.0+a
  rm "$ROBOT/run/fail-self-test"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_a_start_during_the_self_test_takes_the_new_version_back_and_is_reported() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  : >"$ROBOT/run/start-in-self-test"
  run_install --bundle "$v2"
  expect_status 4
  expect_said "$msg_started_meanwhile"
  expect_version 0.1.0+a
  expect_confirmed
  rm "$ROBOT/run/start-in-self-test"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

# A supervisor that systemd starts repeatedly: the next start would come within seconds.
scenario_a_unit_is_stopped_before_a_new_version_is_tried() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  mkdir -p "$ROBOT/run/systemd/system"
  printf '#!/bin/sh\necho "$* $(readlink /opt/darwinop/current)" >>/run/systemctl-calls\n' >"$ROBOT/bin/systemctl"
  chmod 755 "$ROBOT/bin/systemctl"
  run_install --bundle "$v1"
  run_install --bundle "$v2"
  expect_status 0
  grep -qx 'stop darwinop.service versions/0.1.0+a' "$ROBOT/run/systemctl-calls" || fail "systemctl was asked: $(cat "$ROBOT/run/systemctl-calls")"
}

scenario_bundle_whose_manifest_lies() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  robot_quiet
  remember_disk
  printf X | dd of="$LAB/bundles/0.2.0+b/share/darwinop/ballast" bs=1 seek=77 conv=notrunc status=none
  pack "$LAB/bundles/0.2.0+b" "$v2"
  run_install --bundle "$v2"
  expect_status 1
  robot_quiet
  expect_same_disk "a bundle with a damaged file was let in"
  expect_version 0.1.0+a
}

scenario_bundle_with_more_or_other_than_its_manifest_names() {
  local v1 v2 folder=$LAB/bundles/0.2.0+b wrong; v1=$(fake_bundle 0.1.0+a)
  run_install --bundle "$v1"
  robot_quiet
  remember_disk
  for wrong in 'echo x >bin/unlisted' 'ln -s /etc/shadow share/shadow' 'ln -sf /bin/true bin/darwinop-run' 'mknod bin/device c 1 3' \
    'mkdir -p share/more && cp /bin/true share/more/-odd'; do
    v2=$(fake_bundle 0.2.0+b)
    (cd "$folder" && eval "$wrong")
    pack "$folder" "$v2"
    run_install --bundle "$v2"
    expect_status 1
    expect_said "$msg_not_in_manifest|$msg_not_regular"
    expect_same_disk "let in: $wrong"
  done
}

scenario_no_program_of_a_bundle_gets_more_rights_than_its_caller() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  chmod 6777 "$LAB/bundles/0.1.0+a/bin/darwinop-doctor"
  chmod 600 "$LAB/bundles/0.1.0+a/bin/darwinop-monitor" 2>/dev/null || chmod 600 "$LAB/bundles/0.1.0+a/share/darwinop/robot.ini"
  pack "$LAB/bundles/0.1.0+a" "$v1"
  run_install --bundle "$v1"
  expect_status 0
  [ -z "$(find "$ROBOT/opt/darwinop/versions" ! -type l \( -perm /6022 -o ! -perm -444 \))" ] ||
    fail "rights: $(find "$ROBOT/opt/darwinop/versions" ! -type l \( -perm /6022 -o ! -perm -444 \) -ls)"
}

scenario_names_in_dev_shm_that_somebody_took_do_no_harm() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  # shellcheck disable=SC2046  # one name a word
  (cd "$ROBOT/dev/shm" && mkfifo $(seq -f 'darwinop-check-%.0f' 1 9000))
  run_install --bundle "$v1"
  expect_status 0
}

scenario_robot_that_stays_under_torque() {
  local v1 v2 what; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  expect_status 0
  echo 'under torque: LegLowerR' >"$ROBOT/run/stays-stiff"
  for what in "--bundle $v2" --uninstall; do
    # shellcheck disable=SC2086  # an option and its value
    run_install $what
    expect_status 1
    expect_said 'under torque: LegLowerR'
    expect_version 0.1.0+a
    ! grep -q '^0.2.0' "$ROBOT/run/doctor-calls" || fail "the new version ran on a robot under torque"
  done
  run_install --force --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_bundle_that_is_cut_or_no_bundle() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b 200)
  run_install --bundle "$v1"
  robot_quiet
  remember_disk
  truncate -s 100000 "$v2"
  run_install --bundle "$v2"
  expect_status 1 2
  echo 'no archive' >"$v2"
  run_install --bundle "$v2"
  expect_status 1 2
  robot_quiet
  expect_same_disk "a broken bundle changed something"
}

# Bytes that change on their way: the PC says another checksum than that of what it sends.
scenario_digest_that_is_wrong() {
  local v1 v2 name; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  robot_quiet
  remember_disk
  for name in cksum md5sum sha1sum sha256sum; do
    pc_program $name <<END
#!/bin/sh
: >$LAB/digest_asked_for
/usr/bin/$name "\$@" | sed 's/^[0-9a-f]/1&/'
END
  done
  run_install --bundle "$v2"
  [ -e "$LAB/digest_asked_for" ] || fail "the installer took no checksum on the PC"
  rm "$LAB"/pc/bin/*
  expect_status 1
  robot_quiet
  expect_same_disk "an archive with a wrong checksum changed something"
  expect_version 0.1.0+a
}

scenario_two_installs_at_once() {
  local v1 v2 first=0; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  hold_an_install "$v1"
  run_install --bundle "$v2"
  expect_status 5
  run_install --uninstall
  expect_status 5
  rm "$ROBOT/run/hold-self-test"
  wait "$held" || first=$?
  [ $first = 0 ] || fail "the first install ended with $first"
  expect_version 0.1.0+a
  expect_confirmed
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_lock_of_a_dead_install_is_taken_over() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  hold_an_install "$v2"
  robot_kill_sessions
  wait "$held" || true
  [ -e "$ROBOT/opt/darwinop/lock" ] || fail "the test does not show what it wants: no lock was left"
  rm "$ROBOT/run/hold-self-test"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
  expect_confirmed
}

run_scenarios "$@"
