#!/usr/bin/env bash
# What needs the speed of the release build and no real time: darwinop gap, minutes of simulated time, campaigns of faults.
# builds: release-tests all
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests simulated -j "$(nproc)"
