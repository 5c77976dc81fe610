#!/usr/bin/env bash
# The tests in real time in the debug build, for developers.
# builds: debug all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests slow -j "$(nproc)"
