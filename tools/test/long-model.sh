#!/usr/bin/env bash
# All configurations of the model: hours (docs/proven.md).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
build asan-ubsan print_model_tables
tools/model-check.sh build/asan-ubsan/bin deep
