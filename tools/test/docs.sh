#!/usr/bin/env bash
# Links, commands and tables of the documentation; the tests that the hazard table names.
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
tools/check_docs.sh
mapfile -t programs < <(tools/pages.sh programs --fast)
build asan-ubsan "${programs[@]}"
build_hazard_tests asan-ubsan
tools/pages.sh check build/asan-ubsan --fast
