#!/usr/bin/env bash
# Renews the generated pages of docs/ (tools/pages.txt).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh

mapfile -t programs < <(tools/pages.sh programs)
build debug "${programs[@]}"
# The page of hazards needs the results of its tests.
build debug print_hazards
mapfile -t tests < <(build/debug/bin/print_hazards --tests | sort -u)
mapfile -t programs < <(printf '%s\n' "${tests[@]}" | grep -v '\.')
build debug "${programs[@]}"
ctest --test-dir build/debug --quiet -j "$(nproc)" -R "^($(IFS='|' && echo "${tests[*]//./\\.}"))$"
tools/pages.sh write build/debug
