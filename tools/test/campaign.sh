#!/usr/bin/env bash
# 10^8 cycles of the real loop against the virtual robot in simulated time, under random faults, on all cores: hours.
# builds: release-tests campaign_deep
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
build/release/bin/campaign_deep "${DARWINOP_DEEP_CYCLES:-100000000}" "$DARWINOP_SEED"
