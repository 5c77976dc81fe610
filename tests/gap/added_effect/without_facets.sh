#!/bin/sh
# Removes each field of an effect in turn: SOURCE must compile with all of them, and not with one less.
# Usage: without_facets.sh PROJECT COMPILER
set -u
project=$1 compiler=$2 source=$1/tests/gap/added_effect/return_spring.cpp
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
compiles() { "$compiler" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$project" "$1" 2>"$folder/errors"; }

compiles "$source" || { cat "$folder/errors"; exit 1; }
fields=$(sed -n '/^const EffectInfo/,/^}};/s/^    \.\([a-z_]*\) = .*/\1/p' "$source")
[ "$(echo "$fields" | wc -l)" -ge 19 ] || { echo "too few fields found: $fields"; exit 1; }
for field in $fields; do
  # The field's lines: up to the next field.
  awk -v field="$field" '/^const EffectInfo/ { inside = 1 } /^}};/ { inside = 0; skip = 0 }
    inside && /^    \./ { skip = ($1 == "." field) } !skip' "$source" >"$folder/effect.cpp"
  if compiles "$folder/effect.cpp"; then
    echo "an effect without .$field compiles; the field must be Required in twin/servo/effect.hpp"
    exit 1
  fi
done
