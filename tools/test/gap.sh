#!/usr/bin/env bash
# darwinop gap: its longest tests, a few cases found blind, experiments and identification from end to end.
# builds: release-tests darwinop-gap gap_tests
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests gap -j "$(nproc)"
