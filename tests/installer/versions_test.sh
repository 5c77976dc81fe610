#!/usr/bin/env bash
# Version on the robot after install, reinstall, upgrade, downgrade, rollback, status, uninstall.
. "$(dirname "$(readlink -f "$0")")/robot.sh"

scenario_fresh_robot() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  expect_confirmed
  grep -q '^0.1.0+a' "$ROBOT/run/doctor-calls" || fail "no self-test was run on the robot"
  [ -s "$ROBOT/opt/darwinop/robot.ini" ] || fail "there is no robot.ini to edit"
  expect_boots 0.1.0+a
  expect_no_demo
}

scenario_same_version_again_changes_nothing() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install --bundle "$v1"
  expect_status 0
  robot_quiet
  remember_disk --touched
  run_install --bundle "$v1"
  expect_status 0
  expect_said "$msg_nothing_to_do"
  robot_quiet
  expect_same_disk --touched "installing the same version twice changed something"
}

# As from a source archive without git: every build has the same number.
scenario_any_other_build_of_the_same_number_is_installed() {
  local kilobytes
  for kilobytes in 20 21 22 20; do
    run_install --bundle "$(fake_bundle 0.1.0 "$kilobytes")"
    expect_status 0
    expect_confirmed
  done
}

# refuse_user: as while another program has locked the user database.
refuse_user() {
  sed -i '/^darwinop:/d' "$ROBOT/etc/passwd"
  rm "$ROBOT/bin/useradd"
  printf '#!/bin/sh\nexit 1\n' >"$ROBOT/bin/useradd"
  chmod 755 "$ROBOT/bin/useradd"
}

scenario_a_confirmed_version_stays_if_a_later_step_fails_when_it_is_repeated() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  refuse_user
  run_install --bundle "$v1"
  expect_status 1
  expect_said "$msg_stays"
  expect_version 0.1.0+a
  expect_confirmed
  expect_boots 0.1.0+a
  rm "$ROBOT/bin/useradd"
  ln -s /.host/sbin/useradd "$ROBOT/bin/"
  run_install --bundle "$v2"
  expect_status 0
  refuse_user
  run_install --bundle "$v2"
  expect_status 1
  expect_said "$msg_stays"
  expect_version 0.2.0+b
}

scenario_upgrade_keeps_robot_ini() {
  local v1 v2; v1=$(fake_bundle 0.9.0+a); v2=$(fake_bundle 0.10.0+b)  # numeric comparison
  run_install --bundle "$v1"
  printf '[Robot]\nport = /dev/ttyUSB7\n' >"$ROBOT/opt/darwinop/robot.ini"
  ln -s ttyUSB0 "$ROBOT/dev/ttyUSB7"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.10.0+b
  expect_confirmed
  grep -q ttyUSB7 "$ROBOT/opt/darwinop/robot.ini" || fail "the upgrade overwrote robot.ini"
  expect_boots 0.10.0+b
}

scenario_downgrade_is_refused_unless_forced() {
  local old new; old=$(fake_bundle 0.9.0+a); new=$(fake_bundle 0.10.0+b)
  run_install --bundle "$new"
  robot_quiet
  remember_disk --touched
  run_install --bundle "$old"
  expect_status 1
  expect_said '--force'
  expect_version 0.10.0+b
  robot_quiet
  expect_same_disk --touched "a refused downgrade changed something"
  run_install --force --bundle "$old"
  expect_status 0
  expect_version 0.9.0+a
  expect_boots 0.9.0+a
}

scenario_another_build_of_the_same_number_is_installed() {
  local v1 v2; v1=$(fake_bundle 0.1.0+1111111); v2=$(fake_bundle 0.1.0+0000000.dirty)
  run_install --bundle "$v1"
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.1.0+0000000.dirty
}

scenario_rollback_there_and_back() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  run_install --bundle "$v1"
  run_install --bundle "$v2"
  expect_version 0.2.0+b
  run_install --rollback
  expect_status 0
  expect_version 0.1.0+a
  expect_confirmed
  expect_boots 0.1.0+a
  run_install --bundle "$v2"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_a_start_of_the_default_controller_is_announced() {
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_not_said "$msg_keep_clear"
  ln -s controllers/walker "$ROBOT/opt/darwinop/default"
  run_install --bundle "$(fake_bundle 0.2.0+b)"
  expect_said "$msg_keep_clear: walker "
  run_install --rollback
  expect_said "$msg_keep_clear: walker "
}

scenario_rollback_with_nothing_to_go_back_to() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install --rollback
  expect_status 1
  run_install --bundle "$v1"
  run_install --rollback
  expect_status 1
  expect_version 0.1.0+a
}

scenario_status_changes_nothing() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  remember_disk --touched
  run_install --status
  expect_status 0
  expect_said "$msg_nothing_installed"
  expect_same_disk --touched "--status changed something on a fresh robot"
  run_install --bundle "$v1"
  robot_quiet
  remember_disk --touched
  run_install --status
  expect_status 0
  expect_said '0\.1\.0\+a'
  expect_same_disk --touched "--status changed something"
}

scenario_dry_run_changes_nothing() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  remember_disk --touched
  run_install --dry-run --bundle "$v1"
  expect_status 0
  expect_said '0\.1\.0\+a'
  expect_said 'rc\.local'
  robot_quiet
  expect_same_disk --touched "--dry-run changed something on a fresh robot"
  run_install --bundle "$v1"
  robot_quiet
  remember_disk --touched
  run_install --dry-run --bundle "$v2"
  expect_status 0
  expect_said '0\.2\.0\+b'
  run_install --dry-run --uninstall
  expect_status 0
  robot_quiet
  expect_same_disk --touched "--dry-run changed something"
  expect_version 0.1.0+a
}

scenario_uninstall_leaves_the_disk_as_it_was() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  remember_disk
  cp -a "$ROBOT/etc/rc.local" "$LAB/rc.local"
  run_install --bundle "$v1"
  run_install --bundle "$v2"
  expect_boots 0.2.0+b
  mkdir -p "$ROBOT/opt/darwinop/controllers/mine"
  run_install --uninstall
  expect_status 0
  robot_quiet
  [ -z "$(pgrep -f darwinop-supervisor || true)" ] || fail "the supervisor still runs after uninstall"
  expect_same_disk "uninstall did not bring the disk back"
  expect_boots_nothing_of_ours
}

scenario_uninstall_shows_what_was_written_into_robot_ini() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  run_install --bundle "$v1"
  printf '%s\n' '[Offsets]' 'Neck = 0.012' >>"$ROBOT/opt/darwinop/robot.ini"
  run_install --uninstall
  expect_status 0
  expect_said '^    Neck = 0\.012$'
  expect_not_said '^    \[Robot\]'
  run_install --bundle "$v1"
  run_install --uninstall
  expect_not_said "$msg_differ"
  run_install --bundle "$v1"
  echo 'Head = 0.034' >>"$ROBOT/opt/darwinop/robot.ini"
  rm "$ROBOT/opt/darwinop/current"
  run_install --uninstall
  expect_said '^    Head = 0\.034$'
}

# The line of a user in the robot's file, or nothing.
account() { grep "^darwinop:" "$ROBOT/etc/$1" || true; }

scenario_controllers_get_a_user_without_rights_and_uninstall_removes_it() {
  local userland
  for userland in gnu busybox; do
    [ $userland = gnu ] || robot_new busybox
    printf '%s\n' audio:x:29: >>"$ROBOT/etc/group"
    remember_disk
    run_install --bundle "$(fake_bundle 0.1.0+a)"
    expect_status 0
    expect_said 'created the user darwinop'
    [[ $(account passwd) =~ ^darwinop:[x*]:[1-9][0-9]{2}:[0-9]+:.*:/nonexistent:/bin/false$ ]] || fail "the user is: $(account passwd)"
    grep -q '^video:x:44:darwin,darwinop$' "$ROBOT/etc/group" || fail "no camera for it: $(grep ^video "$ROBOT/etc/group")"
    grep -q '^audio:x:29:darwinop$' "$ROBOT/etc/group" || fail "no sound for it"
    run_install --bundle "$(fake_bundle 0.2.0+b)"
    expect_not_said "$msg_created_user"
    run_install --uninstall
    expect_status 0
    expect_same_disk "the user or the group stayed"
  done
}

# fail_on PROGRAM FILE: from now on it writes half of its output for this file, and fails.
fail_on() {
  rm "$ROBOT/bin/$1"
  cat >"$ROBOT/bin/$1" <<END
#!/bin/sh
case "\$*" in *darwinop*$2) head -n 1 $2; exit 1 ;; esac
exec /.host/bin/busybox $1 "\$@"
END
  chmod 755 "$ROBOT/bin/$1"
}

scenario_a_tool_that_fails_leaves_the_user_database_whole() {
  robot_new busybox
  remember_disk
  fail_on awk /etc/group
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 1
  rm "$ROBOT/bin/awk"
  ln -s /.host/bin/busybox "$ROBOT/bin/awk"
  expect_same_disk "half a file replaced the groups"
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 0
  cp "$ROBOT/etc/passwd" "$LAB/passwd"
  fail_on sed /etc/passwd
  run_install --uninstall
  cmp -s "$ROBOT/etc/passwd" "$LAB/passwd" || fail "half a file replaced the users"
}

scenario_a_user_that_was_there_stays() {
  echo 'darwinop:x:990:990::/home/darwinop:/bin/sh' >>"$ROBOT/etc/passwd"
  remember_disk
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 0
  grep -q '^darwinop:x:' "$ROBOT/etc/group" || fail "the runtime has no group"
  run_install --uninstall
  expect_same_disk "uninstall took more, or less, than was made"
}

scenario_a_robot_ini_that_names_somebody_gets_no_user() {
  mkdir -p "$ROBOT/opt/darwinop"
  printf '[Robot]\ncontroller_user = root ; as before\n' >"$ROBOT/opt/darwinop/robot.ini"
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 0
  [ -z "$(account passwd)$(account group)" ] || fail "a user was made"
}

scenario_a_first_installation_that_fails_leaves_no_user() {
  remember_disk
  : >"$ROBOT/run/fail-self-test"
  run_install --bundle "$(fake_bundle 0.1.0+a)"
  expect_status 1
  expect_same_disk "something was left"
}

scenario_uninstall_twice_and_on_a_robot_without() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  remember_disk
  run_install --uninstall
  expect_status 0
  expect_same_disk "uninstalling nothing changed something"
  run_install --bundle "$v1"
  run_install --uninstall
  expect_status 0
  run_install --uninstall
  expect_status 0
  expect_said "$msg_nothing_installed"
  expect_same_disk "the second uninstall changed something"
  run_install --bundle "$v1"
  expect_status 0
  expect_boots 0.1.0+a
}

# What busybox's sh and tools cannot do, a robot of 2009 may not be able to do either.
scenario_a_life_on_a_robot_with_nothing_but_busybox() {
  local v1 v2; v1=$(fake_bundle 0.1.0+a); v2=$(fake_bundle 0.2.0+b)
  robot_new busybox
  remember_disk
  run_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
  run_install --bundle "$v2"
  expect_status 0
  expect_boots 0.2.0+b
  expect_no_demo
  run_install --rollback
  expect_status 0
  expect_boots 0.1.0+a
  run_install --status
  expect_status 0
  expect_not_said 'not found|unrecognized|invalid option|applet'  # no message of ours
  run_install --uninstall
  expect_status 0
  robot_quiet
  expect_same_disk "uninstall did not bring the disk back"
}

scenario_pc_with_busybox_sh() {
  local v1; v1=$(fake_bundle 0.1.0+a)
  pc_program busybox-install <<END
#!/bin/sh
exec busybox sh "$installer" "\$@"
END
  installer=$LAB/pc/bin/busybox-install
  run_install --bundle "$v1"
  expect_status 0
  expect_version 0.1.0+a
}

scenario_default_bundle_is_the_newest_built_one() {
  local copy=$LAB/copy
  mkdir -p "$copy/build/robot"
  cp -r "$SOURCE/installer" "$SOURCE"/rc.local.template "$copy/"
  cp "$(fake_bundle 0.1.0+a)" "$copy/build/robot/"
  touch -d '1 hour ago' "$copy/build/robot/"*
  cp "$(fake_bundle 0.2.0+b)" "$copy/build/robot/"
  installer=$copy/installer/darwinop-install
  run_install
  rm -rf "$copy"
  expect_status 0
  expect_version 0.2.0+b
}

scenario_the_environment_of_the_user_does_no_harm() {
  mkdir "$LAB/precious"
  status=0
  connection=$LAB/precious "$installer" --bundle /nonexistent >"$LAB/out" 2>&1 || status=$?
  expect_status 1
  [ -d "$LAB/precious" ] || fail "the installer removed a folder that a variable of the user names"
}

scenario_wrong_command_lines() {
  run_install --no-such-option
  expect_status 2
  run_install --dry-run --stop  # would stop something
  expect_status 2
  run_install --bundle /nowhere/bundle.tar.gz
  expect_status 1 2
  expect_said '/nowhere/bundle.tar.gz'
}

run_scenarios "$@"
