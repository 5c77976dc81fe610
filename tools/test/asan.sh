#!/usr/bin/env bash
# Fast and slow tests and the stored inputs of the fuzzers, under address and undefined-behaviour sanitizers; then the page
# of hazards, which names those tests.
# builds: asan-ubsan all fuzzers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
builds
rm -rf build/asan-ubsan/results
run_side_by_side asan -j "$places"
measure_tests asan-real-time
tools/pages.sh check build/asan-ubsan docs/hazards.md
