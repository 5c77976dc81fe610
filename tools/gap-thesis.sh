#!/usr/bin/env bash
# gap-thesis.sh BIN [SEED]: findings of 2013 that need the whole robot, as cases: made, run blind, printed as a table in
# Markdown (docs/gap/thesis.md). Some ten minutes on two cores. Results stay in build/gap-thesis; the same command with the
# same program goes on where it was stopped.
set -euo pipefail
bin=$(cd "$1" && pwd)
seed=${2:-2013}
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

program=$(sha256sum "$bin/darwinop-gap" | cut -c1-12)
folder=build/gap-thesis/$program-$seed
if [ ! -e "$folder/key.json" ]; then
  rm -rf "$folder"  # a key is written last: without one the cases are not all there
  "$bin/darwinop-gap" benchmark make --family thesis --seed "$seed" --out "$folder"
fi
"$bin/darwinop-gap" benchmark run "$folder/cases" --out "$folder/results.json" --resume
"$bin/darwinop-gap" benchmark score "$folder/results.json" "$folder/key.json" --table
