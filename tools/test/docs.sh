#!/usr/bin/env bash
# Links, commands and tables of the documentation.
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh

no_aslr
tools/check_docs.sh
mapfile -t programs < <(tools/pages.sh programs --fast)
build asan-ubsan "${programs[@]}"
tools/pages.sh check build/asan-ubsan --fast
