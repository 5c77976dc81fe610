#!/usr/bin/env bash
# Runs test stages, each a script tools/test/STAGE.sh, and prints their times and results.
#
#   run.sh [STAGE...]          the gate, or the named stages; stops at the first that fails
#   run.sh deep [STAGE...]     the stages that are too long for the gate, or the named ones; goes on after a failure
#   run.sh --list gate|deep    their names
#
# Builds, and stages that only compute, run beside the tests: background.sh. A stage that has to wait for a build lifts its
# priority. Rows of the report are kept in build/rows.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh
. tools/test/background.sh

gate=(format scripts build docs model asan release i686 install tsan arm-short tidy simulated)
deep=(lint headers gap gap-sanitized long-model campaign long-install vm vm-aarch64 vm-armhf vm-amd64 n270 arm i686-native fuzz bench)
more=(fast slow)  # for developers: one label of the debug build

# Whether this kernel runs 32-bit programs: an ELF file that only ends.
runs_32_bit() {
  local program status=0
  program=$(mktemp)
  printf '\177ELF\1\1\1\0\0\0\0\0\0\0\0\0\2\0\3\0\1\0\0\0\124\200\4\10\64\0\0\0\0\0\0\0\0\0\0\0\64\0\40\0\1\0\0\0\0\0\0\0' >"$program"
  printf '\1\0\0\0\0\0\0\0\0\200\4\10\0\200\4\10\133\0\0\0\133\0\0\0\5\0\0\0\0\20\0\0\61\300\100\61\333\315\200' >>"$program"
  chmod +x "$program"
  env "$program" 2>/dev/null || status=$?
  rm "$program"
  return "$status"
}
# The robot's own programs cannot be tested here, and the gate says so: `./dev test i686 install` elsewhere.
not_run=()
without_32_bit() {
  local stage kept=()
  for stage in "${gate[@]}"; do
    case $stage in i686 | install) not_run+=("$stage") ;; *) kept+=("$stage") ;; esac
  done
  gate=("${kept[@]}")
  say "NOT RUN: ${not_run[*]}: this kernel runs no 32-bit programs (boot it with ia32_emulation=on)"
}

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
if [ $# = 0 ]; then
  runs_32_bit || without_32_bit
  set -- "${gate[@]}"
fi
groups=(build test robot)
for stage in "$@"; do
  has_stage "$stage" || die "no stage '$stage'. Gate: ${gate[*]}. Deep: ${deep[*]}. Debug build: ${more[*]}"
  [[ " ${deep[*]} " != *" $stage "* ]] || groups=(build test robot robot-arm deep bench)
  [ "$stage" != arm-short ] || groups+=(robot-arm)
done
# Every draw of a test follows from these seeds. The gate always uses the same; deep has another every day.
day=$(date +%Y%m%d)
export DARWINOP_SEED=${DARWINOP_SEED:-${keep_going:+$day}}
export DARWINOP_SEED=${DARWINOP_SEED:-2026} DARWINOP_WINDOW=ON DARWINOP_PYTHON=ON
export RC_PARAMS=${RC_PARAMS:-seed=$DARWINOP_SEED}
say "seeds: DARWINOP_SEED=$DARWINOP_SEED RC_PARAMS=$RC_PARAMS"

# Alone and in deep, a stage that only computes is like the others.
beside=() first=()
for stage in "$@"; do
  if [ $# -gt 1 ] && [ -z "$keep_going" ] && computes_only "$stage"; then beside+=("$stage"); else first+=("$stage"); fi
done

trap stop_background EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

mkdir -p build
rm -rf build/*.summary build/rows
mkdir build/rows
need build
start_background "$@"
need "${groups[@]}"
rm -f build/ahead/packages
failed=()
for stage in "${first[@]}"; do
  say "stage $stage"
  run_stage "$stage" || failed+=("$stage")
  for other in "${beside[@]}"; do ! has_failed "$other" || failed+=("$other"); done
  [ ${#failed[@]} = 0 ] || [ -n "$keep_going" ] || break
done
if [ ${#failed[@]} = 0 ]; then finish_background; fi
stop_background
for stage in "${beside[@]}"; do
  # Without a row it was killed: by this script after a failure, otherwise by somebody else.
  if has_failed "$stage" || { [ ${#failed[@]} = 0 ] && [ ! -e "build/rows/$stage" ]; }; then
    [[ " ${failed[*]} " == *" $stage "* ]] || failed+=("$stage")
    say "stage $stage, in the background:"
    cat "build/$stage.log" || :
  fi
done
report "$@" builds
cat build/*.summary 2>/dev/null || :
[ ${#failed[@]} = 0 ] || die "FAILED: ${failed[*]}. To repeat: ./dev test ${keep_going:+deep }${failed[0]}"
[ ${#not_run[@]} = 0 ] || say "NOT RUN: ${not_run[*]}: this kernel runs no 32-bit programs"
say "all stages passed"
