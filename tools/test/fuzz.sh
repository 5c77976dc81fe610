#!/usr/bin/env bash
# Every fuzzer for two core minutes; adds to the fuzz ledger and docs/fuzzing.md. Findings and inputs stay in build/fuzz.
# builds: fuzz fuzzers
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
tools/fuzz-ledger.sh deep 120
