#!/usr/bin/env bash
# Packets and pixel kernels of the programs for 64-bit ARM boards on an emulated processor: the short part of stage arm, which
# says what the emulator cannot show.
# builds: robot-aarch64 core_test hal_pixels_test
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
for test in core_test hal_pixels_test; do qemu-aarch64 "build/robot-aarch64/bin/$test" --gtest_brief=1; done
