#!/usr/bin/env bash
# Format of the sources, and no leftovers of a merge.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

sources '*.cpp' '*.hpp' '*.h' | xargs -P "$(nproc)" -n 100 clang-format --dry-run -Werror
if git grep -nE '^(<{7}|>{7})( |$)'; then die "conflict markers of a merge"; fi
