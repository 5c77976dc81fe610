#!/usr/bin/env bash
# gap-suite.sh BIN [--cases N] [--seed N]: runs and scores the benchmark of `darwinop gap`, blind: the cases of another
# simulator, if $DARWINOP_SHARED/gap-cases exists, and our own. Results stay in build/gap-suite: the same command resumes an
# interrupted run; another build of the program starts again.
set -euo pipefail
bin=$(cd "$1" && pwd)
shift
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

cases=0 seed=20131
while [ $# -gt 0 ]; do
  case $1 in
    --cases) cases=${2:?--cases needs a number} ;;
    --seed) seed=${2:?--seed needs a number} ;;
    *)
      echo "gap-suite: no option '$1'; there are --cases N and --seed N" >&2
      exit 2
      ;;
  esac
  shift 2
done

program=$(sha256sum "$bin/darwinop-gap" | cut -c1-12)
gap() { "$bin/darwinop-gap" "$@"; }

# run NAME CASES KEY: answers what has no answer yet, and says how good all of it is.
run() {
  local results=build/gap-suite/$1.$program.json status=0
  gap benchmark run "$2" --out "$results" --resume || status=$?
  echo
  echo "== $1: darwinop gap benchmark score $results $3"
  gap benchmark score "$results" "$3" | tee "build/gap-suite/$1.$program.txt"
  return "$status"
}

mkdir -p build/gap-suite
status=0
own=own-$seed
[ "$cases" = 0 ] || own=$own-$cases
if [ ! -e "build/gap-suite/$own/key.json" ]; then
  rm -rf "build/gap-suite/$own"  # a key is written last: without one the cases are not all there
  gap benchmark make --part all --seed "$seed" --cases "$cases" --out "build/gap-suite/$own"
fi
examples=${DARWINOP_SHARED:-}/gap-cases
if [ -e "$examples/key.json" ] && [ "$cases" = 0 ]; then
  run examples "$examples/cases" "$examples/key.json" || status=$?
fi
run "$own" "build/gap-suite/$own/cases" "build/gap-suite/$own/key.json" || status=$?
exit "$status"
