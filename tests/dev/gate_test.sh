#!/usr/bin/env bash
# The gate with stages that do next to nothing: results, report and end of what runs in the background.
set -euo pipefail
source=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
tree=$(mktemp -d)
run=
clean_up() {
  for process in $run $(cat "$tree/docs.pid" 2>/dev/null); do kill "$process" 2>/dev/null || :; done
  rm -rf "$tree"
}
trap clean_up EXIT
cd "$tree"
mkdir -p tools/test
cp -r "$source/tools/dev" tools/
cp "$source/tools/test/run.sh" "$source/tools/test/background.sh" "$source/tools/test/ahead.sh" tools/test/
: >tools/packages.txt  # installs nothing

stage() { # NAME LINE COMMANDS
  printf '#!/usr/bin/env bash\n# %s\nset -eu\n%s\n' "$2" "$3" >"tools/test/$1.sh"
  chmod +x "tools/test/$1.sh"
}
good() {
  local name
  for name in $(tools/test/run.sh --list gate); do stage "$name" 'in the foreground' :; done
  for name in docs model tidy; do stage "$name" 'computes only' :; done
}
wrong() {
  echo "gate: $*" >&2
  cat out >&2
  exit 1
}
gate() { tools/test/run.sh "$@" >out 2>&1 </dev/null; }
row() { grep -qE "^$1 .* $2\$" out || wrong "no row of $1 with: $2"; }
within_20_s() { # COMMAND: waits until it succeeds
  local end=$((SECONDS + 20))
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || wrong "never: $*"
    sleep 0.02
  done
}
gone() { ! kill -0 "$(cat "$1")" 2>/dev/null; }

good
gate || wrong 'stages that pass fail'
row docs 'ok, in the background'
row tsan ok

# Else what is idle takes processors from daemons of the tests.
stage docs 'computes only' 'ps -o sid= -p $$ >docs.session'
gate || wrong 'stages that pass fail'
[ "$(cat docs.session)" != "$(ps -o sid= -p $$)" ] || wrong 'the background has the session of the tests'
stage docs 'computes only' :

# Where no 32-bit program runs, what needs one is left out, and the gate says so; where they run, nothing is.
mkdir fake
printf '#!/bin/sh\nexit 126\n' >fake/env
chmod +x fake/env
PATH=$tree/fake:$PATH gate || wrong 'it fails for want of 32-bit programs'
grep -q 'NOT RUN: i686 install' out || wrong 'it does not say what was not run'
! grep -q '^i686 ' out || wrong 'i686 ran'
printf '#!/bin/sh\n' >fake/env
PATH=$tree/fake:$PATH gate || wrong 'stages that pass fail'
row i686 ok
row install ok

# A failure in the background fails the gate, and its output is shown.
stage tidy 'computes only' 'echo name-is-wrong; exit 3'
! gate || wrong 'a stage that fails in the background is not noticed'
row tidy 'FAILED, in the background'
grep -qx name-is-wrong out || wrong 'no output of the stage that failed'

# So does one that somebody ends.
good
stage docs 'computes only' 'kill -9 $PPID'
! gate || wrong 'a stage that was killed is not noticed'

# Alone, a stage of this kind is like any other.
good
gate docs || wrong 'docs alone fails'
row docs ok

# After a failure or the end of the gate nothing goes on.
stage docs 'computes only' 'echo $$ >docs.pid; exec sleep 1000'
stage asan 'in the foreground' 'until [ -s docs.pid ]; do sleep 0.02; done; exit 1'
! gate || wrong 'a stage that fails is not noticed'
row asan FAILED
within_20_s gone docs.pid
rm docs.pid

stage asan 'in the foreground' :
tools/test/run.sh >out 2>&1 </dev/null &
run=$!
within_20_s test -s docs.pid
kill "$run"
! wait "$run" || wrong 'a gate that was ended succeeds'
run=
within_20_s gone docs.pid
rm docs.pid
