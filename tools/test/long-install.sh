#!/usr/bin/env bash
# The installer as in stage install, with a break at every place instead of one in five.
# builds: release-tests all
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

export DARWINOP_EVERY=1
tools/test/install.sh
