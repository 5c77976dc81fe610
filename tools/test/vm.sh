#!/usr/bin/env bash
# A whole installation's life on a virtual robot's computer, power cuts included, with both ways to start at boot.
# builds: release darwinop-virtual-robot
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
build_robot i686
tests/vm/robot_vm_test.sh
