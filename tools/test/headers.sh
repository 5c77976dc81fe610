#!/usr/bin/env bash
# Each header, and each source file of the rooms, compiled by itself: none needs what another file includes.
# builds: headers all all_verify_interface_header_sets
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

builds
