#!/usr/bin/env bash
# The installer against a real sshd with a root folder of its own, and remote control over ssh.
# builds: release-tests all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
build_robot i686
run_side_by_side install -j "$more_places"
