#!/usr/bin/env bash
# mpi_benchmark.sh MPI DARWINOP_GAP: the program in two processes writes what one writes, to the byte but for the time.
# Cases that cannot be used are cases enough: which rank has which does not depend on what is in them.
set -euo pipefail
mpi=$1 gap=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for name in c001 c002 c003 c004 c005; do
  mkdir -p "$folder/cases/$name"
  echo "{\"case\": \"$name\", \"nonsense\": 1}" >"$folder/cases/$name/case.json"
done
untimed() { grep -v '"runtime_s"' "$1"; }

"$gap" benchmark run "$folder/cases" --out "$folder/alone.json"
"$mpi" 2 "$gap" benchmark run "$folder/cases" --out "$folder/two.json"
[ "$(grep -c '"bad_input"' "$folder/two.json")" = 5 ]
diff <(untimed "$folder/alone.json") <(untimed "$folder/two.json")

# Help, here under a former name, is printed by one rank; an error ends all, with one exit code.
"$mpi" 2 "$gap" battery --help | grep -c -- --resume | grep -qx 1
status=0
"$mpi" 2 "$gap" benchmark run "$folder/nowhere" 2>"$folder/said" || status=$?
[ "$status" = 2 ]
grep -q 'nowhere: not a folder' "$folder/said"
