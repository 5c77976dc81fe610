#!/usr/bin/env bash
# check_hazards.sh BUILD: prints docs/hazards.md. BUILD: a build folder where CTest has run the tests of the hazard table.
set -euo pipefail
build=$(realpath "$1")
"$(dirname "${BASH_SOURCE[0]}")/print_test_results.py" "$build" | "$build/bin/print_hazards"
