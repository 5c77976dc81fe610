#!/usr/bin/env bash
# The robot's programs as this kernel runs them, campaigns included.
# builds: robot all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests i686-native -j "$places"
