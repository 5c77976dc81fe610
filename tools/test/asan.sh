#!/usr/bin/env bash
# Fast and slow tests and the stored inputs of the fuzzers, under address and undefined-behaviour sanitizers.
# builds: asan-ubsan all fuzzers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
builds
run_tests asan -j "$places"
