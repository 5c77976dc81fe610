#!/usr/bin/env bash
# The same as vm.sh on a virtual ARM board, which starts everything through systemd.
# builds: release darwinop-virtual-robot
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
build_robot aarch64
ROBOT_VM_MACHINE=aarch64 tests/vm/robot_vm_test.sh
