#!/usr/bin/env bash
# Checks that the documentation tells the truth where a program can tell: relative links lead somewhere, commands
# that pages show exist, the package table is the one in ./dev, and the fuzz ledger is the one in tests/fuzz/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

failed=0
wrong() {
  echo "$1" >&2
  failed=1
}

pages=$(git ls-files --cached --others --exclude-standard -- '*.md')

for page in $pages; do
  [ -e "$page" ] || continue
  folder=$(dirname "$page")

  while read -r target; do
    [ -e "$folder/$target" ] || wrong "$page: the link to $target leads nowhere"
  done < <(grep -oE '\]\([^)#: ]+' "$page" | sed 's/^](//')

  while read -r command; do
    ./dev help | grep -q "^  $command " || wrong "$page: there is no command ./dev $command"
  done < <(grep -oE '\./dev [a-z][a-z-]*' "$page" | sed 's/.* //' | sort -u)

  while read -r noun; do
    grep -q "darwinop-$noun" apps/CMakeLists.txt || [ -e "installer/darwinop-$noun" ] || wrong "$page: there is no command darwinop $noun"
  done < <(sed -n '/^```/,/^```/p' "$page" | grep -oE '(^|[|&;] *)darwinop [a-z][a-z-]*' | sed 's/.* //' | sort -u)

  while read -r example; do
    [ -d "$example" ] || wrong "$page: there is no $example"
  done < <(grep -oE 'controllers/[0-9][a-z0-9_]+' "$page" | sort -u)
done

if ! diff <(./dev help packages) <(sed '1,/^<!-- packages -->$/d' docs/dependencies.md) >&2; then
  wrong "docs/dependencies.md: the table is not that of ./dev; run ./dev docs"
fi
if ! diff <(tools/fuzz-ledger.sh print) <(sed '1,/^<!-- ledger -->$/d' docs/fuzzing.md) >&2; then
  wrong "docs/fuzzing.md: the table is not that of tests/fuzz/ledger.tsv; run tools/fuzz-ledger.sh page"
fi
[ $failed = 0 ] && echo "docs: links, commands, package table and fuzz ledger are right"
exit $failed
