#!/usr/bin/env bash
# The rooms with threads under the thread sanitizer.
# builds: tsan fast_tests slow_tests threads_tests
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
builds
run_side_by_side tsan -j $((2 * $(nproc)))
