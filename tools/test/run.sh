#!/usr/bin/env bash
# Runs test stages, each a script tools/test/STAGE.sh, and prints their times and results.
#
#   run.sh [STAGE...]          the gate, or the named stages; stops at the first that fails
#   run.sh deep [STAGE...]     the stages that are too long for the gate, or the named ones; goes on after a failure
#   run.sh --list gate|deep    their names
#
# A stage names what it needs built in a line "# builds: PRESET [TARGET...]". One background process builds that for all
# stages, in their order, at idle priority: tests wait most of the time. A stage that has to wait for it lifts the priority.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh

gate=(format scripts build docs model asan release i686 install tsan tidy)
deep=(lint headers gap gap-sanitized long-model campaign long-install vm n270 i686-native fuzz bench)
more=(fast slow)  # for developers: one label of the debug build

has_stage() { [[ " ${gate[*]} ${deep[*]} ${more[*]} " == *" $1 "* ]]; }

if [ "${1:-}" = --list ]; then
  if [ "$2" = deep ]; then echo "${deep[*]}"; else echo "${gate[*]}"; fi
  exit
fi
keep_going=
if [ "${1:-}" = deep ]; then
  keep_going=1
  shift
  [ $# != 0 ] || set -- "${deep[@]}"
fi
[ $# != 0 ] || set -- "${gate[@]}"
groups=(build test robot)
for stage in "$@"; do
  has_stage "$stage" || die "no stage '$stage'. Gate: ${gate[*]}. Deep: ${deep[*]}. Debug build: ${more[*]}"
  [[ " ${deep[*]} " != *" $stage "* ]] || groups=(build test robot deep bench)
done
# Every draw of a test follows from these seeds. The gate always uses the same; deep has another every day.
day=$(date +%Y%m%d)
export DARWINOP_SEED=${DARWINOP_SEED:-${keep_going:+$day}}
export DARWINOP_SEED=${DARWINOP_SEED:-2026} DARWINOP_WINDOW=ON
export RC_PARAMS=${RC_PARAMS:-seed=$DARWINOP_SEED}
say "seeds: DARWINOP_SEED=$DARWINOP_SEED RC_PARAMS=$RC_PARAMS"

builds_of() { sed -n 's/^# builds: //p' "tools/test/$1.sh"; }

# build/ahead has a file for each preset that is not built yet; build/ahead.log has the output.
build_ahead() { # STAGE...
  local stage preset
  rm -rf build/ahead
  mkdir -p build/ahead
  for stage in "$@"; do
    preset=$(builds_of "$stage")
    [ -z "$preset" ] || : >"build/ahead/${preset%% *}"
  done
  : >build/ahead/packages
  set -m  # a process group of its own, to be ended as a whole
  (
    set +m
    trap 'rm -rf build/ahead' EXIT
    chrt --idle --pid 0 "$BASHPID"
    # What users build needs no test packages: it can begin while they are installed.
    [ ! -e build/ahead/release-tests ] || build release || :
    while [ -e build/ahead/packages ]; do sleep 0.2; done
    for stage in "$@"; do
      preset=$(builds_of "$stage")
      [ -f "build/ahead/${preset%% *}" ] || continue  # nothing to build, or built for an earlier stage
      kill -0 $$ || exit  # run.sh itself has ended
      # shellcheck disable=SC2086  # words
      build $preset || :  # the stage that needs it tries once more and shows why
      rm -f "build/ahead/${preset%% *}"
    done
  ) </dev/null >build/ahead.log 2>&1 &
  export DARWINOP_AHEAD=$!
  set +m
}
stop_ahead() {
  # Only while it runs: its number may belong to another process by now.
  if [ -n "${DARWINOP_AHEAD:-}" ] && jobs -rp | grep -qx "$DARWINOP_AHEAD"; then
    { kill "-$DARWINOP_AHEAD" && wait "$DARWINOP_AHEAD"; } 2>/dev/null || :
  fi
}
trap stop_ahead EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# Sets $spent: processor time of all programs that have ended, in seconds.
count_spent() {
  times >build/times
  spent=$(tail -1 build/times | tr 'ms' '  ' | awk '{ printf "%d", $1 * 60 + $2 + $3 * 60 + $4 }')
}

rows=()
report() {
  printf '\n%-12s %7s %7s  %s\n' stage seconds "core s" result
  printf '%s\n' "${rows[@]}"
}

mkdir -p build
rm -f build/*.summary
need build
build_ahead "$@"
need "${groups[@]}"
rm -f build/ahead/packages
failed=()
while [ $# != 0 ]; do
  stage=$1
  shift
  say "stage $stage"
  started=$SECONDS
  count_spent
  before=$spent result=ok
  "tools/test/$stage.sh" || result=FAILED
  count_spent
  rows+=("$(printf '%-12s %7d %7d  %s' "$stage" $((SECONDS - started)) $((spent - before)) $result)")
  if [ $result = FAILED ]; then
    failed+=("$stage")
    [ -n "$keep_going" ] || break
  fi
done
count_spent
before=$spent
[ ${#failed[@]} != 0 ] || wait "$DARWINOP_AHEAD" || :
stop_ahead
count_spent
rows+=("$(printf '%-12s %7s %7d' builds '' $((spent - before)))")
report
cat build/*.summary 2>/dev/null || :
[ ${#failed[@]} = 0 ] || die "FAILED: ${failed[*]}. To repeat: ./dev test ${keep_going:+deep }${failed[0]}"
say "all stages passed"
