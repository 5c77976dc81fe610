#!/usr/bin/env bash
# The programs for ARM boards on emulated processors: those tests that neither wait nor need a serial line, since the
# emulator has no 1 Mbaud; a controller built with each SDK; recordings with the numbers that the PC has. qemu-user gives a
# handler of SIGBUS another address than the program's, a write that a signal interrupts returns 0, and memory is as ordered
# as on the PC: a missing barrier does not show.
# builds: release-tests darwinop-run 01_hello_head 02_symmetry test_controller
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
tests=(core_test bus_test safety_test hil_mocks_test runtime_test hal_pixels_test vision_test)
for architecture in aarch64 armhf; do
  folder=build/robot-$architecture
  case $architecture in
    aarch64) emulator=qemu-aarch64 kind=static ;;
    armhf) emulator=qemu-arm kind=static-fixed ;;
  esac
  build "robot-$architecture" robot_programs darwinop_sdk darwinop-virtual-robot 01_hello_head 02_symmetry test_controller "${tests[@]}"
  nm=$(sed -n 's/^CMAKE_NM:FILEPATH=\(.*\)/\1/p' "$folder/CMakeCache.txt")
  NM=$nm tests/robot/hardened.sh "$folder" "$kind"
  tests/robot/cross_compiled_controllers.sh "$folder" "$PWD" "$architecture" "tools/test/emulated.sh $architecture"
  # shellcheck disable=SC2016  # for the shell that xargs starts
  printf '%s\n' "${tests[@]}" | xargs -P "$(nproc)" -I TEST sh -c '
    timeout 1200 "$1" "$0/bin/TEST" --gtest_brief=1 "--gtest_filter=-*Shorten*:Recorder.SurvivesCtrlC*" >"$0/TEST.log" 2>&1 || {
      echo "TEST ends with status $? on an emulated processor (124: not within 20 minutes), $0:"
      tail -40 "$0/TEST.log"
      exit 1
    }' "$folder" "$emulator"
  tools/test/emulated.sh "$architecture" tests/robot/equal_numbers.sh build/release "$folder"
done
