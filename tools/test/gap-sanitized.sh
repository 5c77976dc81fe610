#!/usr/bin/env bash
# The fast tests of darwinop gap under address and undefined-behaviour sanitizers.
# builds: asan-ubsan gap-fast_tests
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
builds
run_tests asan-gap -j "$places"
