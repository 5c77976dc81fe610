#!/usr/bin/env bash
# print_hazards_test.sh PRINT_HAZARDS: what makes the page of hazards incomplete. Results of test programs are made up.
set -euo pipefail
print=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# results SKIPPED FAILED CYCLES: all tests of the table, measured in hazard_reaction_test.
results() {
  "$print" --tests | paste -d ' ' - - | awk -v skipped="$1" -v failed="$2" -v cycles="$3" '
    { print $1, $2, $2 == skipped ? "skipped" : $2 == failed ? "failed" : "passed",
        $1 == "hazard_reaction_test" ? cycles : "" }' >"$folder/results"
}

# incomplete ID WHAT: the last results are refused, and ID is named.
incomplete() {
  if "$print" <"$folder/results" >"$folder/page" 2>"$folder/errors"; then
    echo "accepted: $2" >&2
    exit 1
  fi
  grep -q "^$1\b" "$folder/errors" || { echo "does not name $1: $2" >&2 && exit 1; }
}

results '' '' 3
"$print" <"$folder/results" >"$folder/page"
grep -q '^H104|.*|48|' "$folder/page" || { echo "no measured time of H104" >&2 && exit 1; }
grep -q '^H702|.*|access|' "$folder/page" || { echo "no reason of H702" >&2 && exit 1; }

results RemotePort.CannotBeBoundByAnotherUser '' 3
incomplete H702 'a skipped test'
results '' RemotePort.CannotBeBoundByAnotherUser 3
incomplete H702 'a failed test'
results '' '' ''
incomplete H104 'a row without a time'
results '' '' 0
incomplete H104 'a reaction before its cause'
