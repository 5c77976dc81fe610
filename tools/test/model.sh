#!/usr/bin/env bash
# Every order of every fault, in a model with the tables of the program (docs/proven.md).
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
build asan-ubsan print_model_tables
tools/model-check.sh build/asan-ubsan/bin gate
