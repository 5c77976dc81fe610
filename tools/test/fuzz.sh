#!/usr/bin/env bash
# Every fuzzer for two core minutes. Findings and new inputs are kept in build/fuzz.
# builds: fuzz fuzzers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
tools/fuzz-ledger.sh run build/fuzz/ledger.tsv 120
