# shellcheck shell=bash
# What run.sh does beside the tests, at idle priority, since tests wait most of the time: first the builds that the stages
# name in lines "# builds: PRESET [TARGET...]", in their order; then the stages with a line "# computes only".
# Sourced by run.sh.

builds_of() { sed -n 's/^# builds: //p' "tools/test/$1.sh"; }
computes_only() { grep -q '^# computes only' "tools/test/$1.sh"; }

# Runs a stage in a process of its own, which counts its processor time, and writes its row of the report to build/rows.
run_stage() ( # STAGE [WHERE]
  started=$SECONDS result=ok
  "tools/test/$1.sh" || result=FAILED
  write_row "$1" $((SECONDS - started)) "$result${2:+, $2}"
  [ $result = ok ]
)
write_row() { # NAME SECONDS RESULT: core seconds are those of the children of this process that have ended
  local cores
  times >"build/rows/$1.times"
  cores=$(tail -1 "build/rows/$1.times" | tr ms '  ' | awk '{ printf "%d", $1 * 60 + $2 + $3 * 60 + $4 }')
  printf '%-12s %7s %7d  %s\n' "$1" "$2" "$cores" "$3" >"build/rows/$1"
}
report() { # NAME...
  printf '\n%-12s %7s %7s  %s\n' stage seconds "core s" result
  for name in "$@"; do cat "build/rows/$name" 2>/dev/null || :; done
}
has_failed() { grep -qs ' FAILED' "build/rows/$1"; }

# build/ahead has a file for each preset that is not built yet; build/ahead.log has the output.
start_background() { # STAGE...; runs those of $beside
  local stage preset
  rm -rf build/ahead
  mkdir -p build/ahead
  for stage in "$@"; do
    preset=$(builds_of "$stage")
    [ -z "$preset" ] || : >"build/ahead/${preset%% *}"
  done
  : >build/ahead/packages
  BESIDE="${beside[*]}" setsid tools/test/ahead.sh $$ "$@" </dev/null >build/ahead.log 2>&1 &
  export DARWINOP_AHEAD=$!
}
background_runs() { [ -n "${DARWINOP_AHEAD:-}" ] && jobs -rp | grep -qx "$DARWINOP_AHEAD"; }
stop_background() {
  # Only while it runs: its number may belong to another process by now.
  background_runs || return 0
  kill -- "-$DARWINOP_AHEAD" 2>/dev/null || return 0
  kill -CONT -- "-$DARWINOP_AHEAD" 2>/dev/null || :  # it may be stopped: tools/test/ctest.sh
  wait "$DARWINOP_AHEAD" 2>/dev/null || :
}
# Nothing else is left to do: at full speed.
finish_background() {
  if background_runs; then
    [ ${#beside[@]} = 0 ] || say "waiting for what runs in the background: ${beside[*]}"
    ahead_at --other
  fi
  wait "$DARWINOP_AHEAD" || :
}
