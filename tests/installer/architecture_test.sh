#!/usr/bin/env bash
# Robots with other computers than the delivered one: which archive is sent, and what is refused.
# shellcheck disable=SC2154  # robot.sh sets what is read here
. "$(dirname "$(readlink -f "$0")")/robot.sh"

# computer MACHINE KERNEL CPUINFO: another board in the robot.
computer() {
  echo "$1" >"$ROBOT/run/machine"
  echo "$2" >"$ROBOT/run/kernel"
  echo "$3" >"$LAB/cpuinfo"
}
neon='Features	: half thumb fastmult vfp edsp neon vfpv3 tls vfpv4 idiva idivt vfpd32 lpae evtstrm crc32'
sse='flags		: fpu sse sse2 ssse3 sse4_1 avx'
pi_2() { computer armv7l 6.1.21-v7+ "$neon"; }
pi_3_with_64_bits() { computer aarch64 6.12.25+rpt-rpi-v8 'Features	: fp asimd evtstrm crc32 cpuid'; }
pc_board() { computer x86_64 6.1.0-18-amd64 "$sse"; }

# installer_with ARCHITECTURE...: a copy of the installer beside archives for these, as ./dev build --robot=... leaves them.
# The version says which it is.
installer_with() {
  local architecture folder
  rm -rf "$LAB/copy"
  mkdir "$LAB/copy"
  cp -r "$SOURCE/installer" "$SOURCE"/rc.local.template "$LAB/copy/"
  for architecture in "$@"; do
    folder=$LAB/copy/build/robot-$architecture
    [ "$architecture" != i686 ] || folder=$LAB/copy/build/robot
    mkdir -p "$folder"
    cp "$(fake_bundle "0.1.0+$architecture" 20 "$architecture")" "$folder/"
  done
  installer=$LAB/copy/installer/darwinop-install
}

scenario_the_archive_for_the_robots_computer_is_sent() {
  local board
  installer_with i686 amd64 armhf aarch64
  for board in true:i686 pc_board:amd64 pi_2:armhf pi_3_with_64_bits:aarch64; do
    robot_new gnu
    "${board%:*}"
    run_install
    expect_status 0
    expect_version "0.1.0+${board#*:}"
    expect_boots "0.1.0+${board#*:}"
  done
}

scenario_a_pc_board_takes_the_archive_of_the_atom_if_there_is_no_other() {
  installer_with armhf i686
  pc_board
  run_install
  expect_status 0
  expect_version 0.1.0+i686
}

scenario_what_was_not_built_is_named_with_its_command() {
  installer_with i686 armhf
  pi_3_with_64_bits
  remember_disk --touched
  run_install
  expect_status 1
  expect_said "$msg_not_built aarch64: .*--robot=aarch64"
  robot_quiet
  expect_same_disk --touched "a robot without an archive was changed"
}

scenario_an_archive_for_another_computer_is_refused() {
  local pair
  for pair in i686:aarch64 armhf:aarch64 aarch64:armhf; do
    local archive; archive=$(fake_bundle 0.1.0+a 20 "${pair%:*}")
    robot_new gnu
    case ${pair#*:} in aarch64) pi_3_with_64_bits ;; armhf) pi_2 ;; esac
    remember_disk --touched
    run_install --bundle "$archive"
    expect_status 1
    expect_said "$msg_archive_is_for ${pair%:*}, but .* --robot=${pair#*:}'"
    robot_quiet
    expect_same_disk --touched "a wrong archive changed something: $pair"
  done
}

scenario_a_computer_that_nothing_is_built_for_is_refused() {
  local archive; archive=$(fake_bundle 0.1.0+a 20 armhf)
  installer_with armhf
  computer armv6l 6.1.21+ 'Features	: half thumb fastmult vfp edsp java tls'
  for archive in '' "--bundle $archive"; do
    # shellcheck disable=SC2086  # an option and its value
    run_install $archive
    expect_status 1
    expect_said "$msg_no_programs \(armv6l\)"
  done
}

scenario_an_arm_processor_without_neon_is_refused() {
  local archive; archive=$(fake_bundle 0.1.0+a 20 armhf)
  computer armv7l 6.1.0 'Features	: half thumb fastmult vfp edsp vfpv3 vfpv3d16 tls'
  run_install --bundle "$archive"
  expect_status 1
  expect_said 'does not support neon'
}

scenario_an_archive_that_names_no_computer_is_for_the_atom() {
  local archive; archive=$(fake_bundle 0.1.0+a)
  rm "$LAB/bundles/0.1.0+a/ARCHITECTURE"
  write_manifest "$LAB/bundles/0.1.0+a"
  pack "$LAB/bundles/0.1.0+a" "$archive"
  run_install --bundle "$archive"
  expect_status 0
  robot_new gnu
  pi_2
  run_install --bundle "$archive"
  expect_status 1
  expect_said "$msg_archive_is_for i686"
}

run_scenarios "$@"
