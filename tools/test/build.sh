#!/usr/bin/env bash
# The build that most stages use: clang++ with address and undefined-behaviour sanitizers.
# builds: asan-ubsan all fuzzers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
builds
