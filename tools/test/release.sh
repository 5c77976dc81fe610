#!/usr/bin/env bash
# What users build, and the tests that need its speed: simulated minutes, campaigns, the installed package, real time
# without sanitizers, the robot window in a browser, CPU instructions of a cycle.
# builds: release-tests all long_tests campaign_tests counting_tests test_controller
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests release -j "$(nproc)"
run_tests real-time
tests/benchmarks/run.sh build/release cycle_instructions
