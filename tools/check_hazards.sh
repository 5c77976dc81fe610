#!/usr/bin/env bash
# Runs the tests of the hazard table; then checks docs/hazards.md (--write: writes it). BUILD: a build folder.
#   tools/check_hazards.sh BUILD [--write]
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
if [ "${2:-}" = --write ]; then
  "$build/bin/print_hazards" "$results" >"$results/page.md"
  mv "$results/page.md" docs/hazards.md
else
  "$build/bin/print_hazards" --check docs/hazards.md "$results"
  echo "hazards: every row has its tests, and they pass"
fi
