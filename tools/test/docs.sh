#!/usr/bin/env bash
# Links, commands and tables of the documentation; the tests that the hazard table names.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
tools/check_docs.sh
build_hazard_tests asan-ubsan
tools/check_hazards.sh build/asan-ubsan
