#!/usr/bin/env bash
# A whole installation's life on a virtual robot's computer, power cuts and a walk included. Stage vm: the robot's Atom, with
# both ways to start at boot; stages vm-MACHINE are links to this file: a board of tools/robot-vm/machines.
# builds: release darwinop-virtual-robot darwinop_twin
set -euo pipefail
stage=$(basename -s .sh "$0")
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

machine=i686
[ "$stage" = vm ] || machine=${stage#vm-}
builds
build_robot "$machine"
ROBOT_VM_MACHINE=$machine tests/vm/robot_vm_test.sh
