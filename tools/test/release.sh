#!/usr/bin/env bash
# What users build: the installed package, Python, real time without sanitizers, the robot window in a browser, CPU
# instructions of a cycle.
# builds: release-tests all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_side_by_side release -j "$(nproc)"
measure_tests real-time
tests/benchmarks/run.sh build/release cycle_instructions
