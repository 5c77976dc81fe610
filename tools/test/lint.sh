#!/usr/bin/env bash
# clang-tidy on the whole tree.
# builds: asan-ubsan all fuzzers precompiled_headers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

tools/test/tidy.sh all
