#!/usr/bin/env bash
# Renews the generated pages of docs/ (tools/pages.txt).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh

mapfile -t programs < <(tools/pages.sh programs)
build debug "${programs[@]}"
build_hazard_tests debug
tools/pages.sh write build/debug
