#!/usr/bin/env bash
# Links, commands and tables of the documentation; the tests that the hazard table names.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
tools/check_docs.sh
build asan-ubsan print_registers print_faults
for page in registers faults; do build/asan-ubsan/bin/print_$page --check docs/$page.md; done
build_hazard_tests asan-ubsan
tools/check_hazards.sh build/asan-ubsan
