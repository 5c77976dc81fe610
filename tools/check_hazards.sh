#!/usr/bin/env bash
# check_hazards.sh BUILD: runs the tests of the hazard table, then prints docs/hazards.md. BUILD: a build folder.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
results=$build/hazards
rm -rf "$results"
mkdir -p "$results"
while read -r program filter; do
  "$build/bin/$program" --gtest_brief=1 --gtest_filter="$filter" --gtest_output="json:$results/$program.json" \
    >"$results/$program.log" 2>&1 || { tail -40 "$results/$program.log" >&2; }
done < <("$build/bin/print_hazards" --programs)
"$build/bin/print_hazards" "$results"
