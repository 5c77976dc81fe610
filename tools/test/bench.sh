#!/usr/bin/env bash
# All benchmarks.
# builds: bench all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
tests/benchmarks/run.sh build/bench
