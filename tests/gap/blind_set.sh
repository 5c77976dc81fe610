#!/usr/bin/env bash
# blind_set.sh BIN: a few cases for every day, run blind and scored: 4 with the seed of every day, so that two days
# compare, and 4 with a fresh seed, which is printed. To see a failure again: DARWINOP_SEED=N. About 2 minutes on 2 cores.
#
# When it fails. A case is fair when it leads nobody astray (named, in an ambiguity of 3 at most, silent, or unknown, as
# the case may be). `score --at-least S` fails when even the upper end of the 95 % Wilson interval of the fair share is
# below S:
#   every day  4 cases, S = 0.90: fails at 2 of 4 (upper end 0.85) and not at 3 of 4 (0.95). Nothing is drawn here.
#   fresh      4 cases, S = 0.80: fails at 1 of 4 (0.70) and not at 2 of 4 (0.85). A finder that is fair in 95 % of cases
#              has 1 of 4 or less once in 2000 runs, one that is fair in half of them in 5 of 16, one that always says the
#              same in nearly all.
set -euo pipefail
bin=$(cd "$1" && pwd)
everyday=20130
fresh=${DARWINOP_SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# blind NAME SEED CASES SHARE
blind() {
  local at=$folder/$1
  echo "blind set: $1, seed $2, $3 cases"
  "$bin/darwinop-gap" make-battery --part quick --seed "$2" --cases "$3" --out "$at"
  mv "$at/key.json" "$folder/$1.key.json"  # out of reach of who is blind
  # What is not answered in time counts as wrong: one hard case of a fresh seed must not take a quarter of an hour.
  timeout 240 "$bin/darwinop-gap" battery "$at/cases" --out "$at/results.json" || [ $? = 124 ]
  "$bin/darwinop-gap" score "$at/results.json" "$folder/$1.key.json" --at-least "$4" || {
    echo "blind set: $1 FAILED; once more: DARWINOP_SEED=$fresh $0 $bin"
    exit 1
  }
}
blind everyday "$everyday" 4 0.90
blind fresh "$fresh" 4 0.80
