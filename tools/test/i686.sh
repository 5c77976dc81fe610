#!/usr/bin/env bash
# The robot's programs and their tests under the system calls of Linux 2.6.31, and with the numbers that the PC has.
# builds: robot all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
build release-tests darwinop-run 01_hello_head 02_symmetry test_controller
programs=build/robot/bin
"$programs/old_kernel_probe" today || die "this kernel does not run 32-bit programs as it should (IA32 emulation)"
run_tests cross
under=$programs/run-as-2.6.31
"$under" "$programs/old_kernel_probe" old
run_side_by_side i686 -j "$more_places"
measure_tests i686-real-time
tests/robot/equal_numbers.sh build/release build/robot
