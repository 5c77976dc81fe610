#!/usr/bin/env bash
# Effects hidden in a few cases and found blind; experiments on a robot, identification and the model after it.
# builds: release-tests darwinop-gap loop_tests
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
run_tests loop
