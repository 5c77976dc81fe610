#!/usr/bin/env bash
# Tests on an emulated Atom N270, a processor without SSE4 and AVX: those that neither wait nor need a serial line, since
# the emulator has no 1 Mbaud. It gives a handler of SIGBUS another address than the program's, and a write that a signal
# interrupts returns 0.
# builds: robot all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
tests=(core_test safety_test safety_property_test bus_test hil_mocks_test link_test runtime_test campaign_test
  cycle_allocation_test webots_test hal_pixels_test)
# shellcheck disable=SC2016  # for the shell that xargs starts
printf '%s\n' "${tests[@]}" | xargs -P "$(nproc)" -I TEST sh -c '
  timeout 600 qemu-i386 -cpu n270 "$0/TEST" --gtest_brief=1 "--gtest_filter=-*Shorten*:Recorder.SurvivesCtrlC*" >build/robot/TEST.log 2>&1 || {
    echo "TEST ends with status $? on an emulated N270 (124: not within 10 minutes)"
    tail -40 build/robot/TEST.log
    exit 1
  }' build/robot/bin
