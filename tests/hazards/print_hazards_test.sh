#!/usr/bin/env bash
# print_hazards_test.sh PRINT_HAZARDS: what makes the page of hazards incomplete. Results of test programs are made up.
set -euo pipefail
print=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# results SKIPPED FAILED CYCLES: all tests of the table, measured in hazard_reaction_test.
results() {
  "$print" --programs | while read -r program filter; do
    tr : '\n' <<<"$filter" | sort -u | awk -v program="$program" -v skipped="$1" -v failed="$2" -v cycles="$3" '
      BEGIN { printf "{\"testsuites\": [" }
      { at = match($0, /\.[^.]*$/); suite = substr($0, 1, at - 1); name = substr($0, at + 1)
        printf("%s{\"name\": \"%s\", \"testsuite\": [{\"name\": \"%s\", \"result\": \"%s\"%s%s}]}", NR > 1 ? ", " : "", suite, name,
          $0 == skipped ? "SKIPPED" : "COMPLETED", $0 == failed ? ", \"failures\": [{}]" : "",
          program == "hazard_reaction_test" && cycles != "" ? ", \"cycles\": \"" cycles "\"" : "") }
      END { print "]}" }' >"$folder/$program.json"
  done
}

# incomplete ID WHAT: the last results are refused, and ID is named.
incomplete() {
  if "$print" "$folder" >"$folder/page" 2>"$folder/errors"; then
    echo "accepted: $2" >&2
    exit 1
  fi
  grep -q "^$1\b" "$folder/errors" || { echo "does not name $1: $2" >&2 && exit 1; }
}

results '' '' 3
"$print" "$folder" >"$folder/page"
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
