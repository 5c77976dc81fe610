#!/usr/bin/env bash
# Checks the documentation: relative links, commands and examples that pages name exist;
# words of tools/words.txt are not used; a type name is defined once; public headers document every method.
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

# Words: a planted one has to be found, then the tree is checked.
planted=$(mktemp)
echo 'int untoldWishes = 0;' >"$planted"  # keep-word
if tools/check_words.pl "$planted" 2>/dev/null; then
  wrong "tools/check_words.pl: does not find a word of tools/words.txt in $planted"
else
  rm "$planted"
fi
tools/check_words.pl || failed=1

tools/check_types.pl || failed=1

# Messages: a test that repeats the words of one has to be found, then all tests are checked.
repeating=$(mktemp)
grep -ohEm1 '"[a-z ]*[a-z] [a-z ]*"' hal/text_file.* >"$repeating"
if tools/check_test_texts.pl "$repeating" 2>/dev/null; then
  wrong "tools/check_test_texts.pl: does not find the words of a message in $repeating"
else
  rm "$repeating"
fi
tools/check_test_texts.pl || failed=1

# Public headers: a method without a comment, one without a unit, and one with a bare number have to be found; then all
# headers are checked.
header=$(mktemp)
printf 'class A {\n public:\n  int plain();\n  /// Speed.\n  double speed();\n  /// As the robot'\''s in 2013.\n  double bare();\n};\n' >"$header"
if [ "$(tools/check_headers.pl "$header" 2>&1 | grep -c "$header")" = 3 ]; then
  rm "$header"
else
  wrong "tools/check_headers.pl: does not find the three mistakes in $header"
fi
tools/check_headers.pl || failed=1

[ $failed = 0 ] && echo "docs: links, commands, words, type names and public headers are right"
exit $failed
