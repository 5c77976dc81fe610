#!/usr/bin/env bash
# blind_set.sh BIN: four cases drawn with DARWINOP_SEED (2026 by default), run blind and scored. One to four minutes on two
# cores. Cases that are always the same: Identification.* of tests/gap/identify.
#
# When it fails. An answer is fair when it is named, in an ambiguity of 3 at most, `none`, or `unknown`, as the case
# requires. `benchmark score --at-least S` fails when even the upper end of the 95 % Wilson interval of the fair share is
# below S: 4 cases, S = 0.80, fail at 1 of 4 (0.70) and not at 2 of 4 (0.85). An identification that is fair in 95 % of
# cases has 1 of 4 or less once in 2000 runs, one that is fair in half of them in 5 of 16, one that always gives the same
# answer in nearly all.
set -euo pipefail
bin=$(cd "$1" && pwd)
seed=${DARWINOP_SEED:-2026}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo "blind set: seed $seed, 4 cases"
"$bin/darwinop-gap" benchmark make --part quick --seed "$seed" --cases 4 --out "$folder/blind"
mv "$folder/blind/key.json" "$folder/key.json"  # out of reach of the run
# What is not answered in time counts as wrong: one hard case of a fresh seed must not take a quarter of an hour.
timeout 240 "$bin/darwinop-gap" benchmark run "$folder/blind/cases" --out "$folder/results.json" || [ $? = 124 ]
"$bin/darwinop-gap" benchmark score "$folder/results.json" "$folder/key.json" --at-least 0.80 || {
  echo "blind set: FAILED; once more: DARWINOP_SEED=$seed $0 $bin"
  exit 1
}
