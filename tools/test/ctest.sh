# shellcheck shell=bash
# Runs test presets (CMakePresets.json). Sourced by the stages.
. tools/dev/build.sh

# builds: builds what the stage names in its line "# builds: PRESET [TARGET...]".
builds() {
  # shellcheck disable=SC2046  # words
  build $(sed -n 's/^# builds: //p' "$0")
}

# no_aslr: starts the stage again without address randomisation, which leaves sanitizers no room on some kernels.
no_aslr() {
  if [ -z "${DARWINOP_NO_ASLR:-}" ] && setarch -R true 2>/dev/null; then DARWINOP_NO_ASLR=1 exec setarch -R "$0"; fi
}

# Places for tests: one that waits, for a robot in real time or for ssh, takes one; one that computes takes three in the
# presets with DARWINOP_WHOLE_PROGRAMS (tests/CMakeLists.txt), and so no more of those run at once than there are processors.
places=$((3 * $(nproc)))
more_places=$((5 * $(nproc)))  # without sanitizers, what waits leaves room for more

# run_tests PRESET [ARGUMENT...]: runs a test preset, started through the program $under, if set. Prints the output of what
# failed and the commands that repeat it. CTest's summary also goes to build/PRESET.summary.
under=
run_tests() {
  local preset=$1 log=build/$1.log status=0 launch='' test
  shift
  [ -z "$under" ] || launch="$under "
  $launch ctest --preset "$preset" "$@" 2>&1 | tee "$log" |
    grep --line-buffered -vE '^ *(Start +[0-9]+: |[0-9]+/[0-9]+ Test.* Passed )' || status=${PIPESTATUS[0]}
  sed -n "s/^[0-9]*% tests passed.*/& ($preset)/p" "$log" >"build/$preset.summary"
  [ "$status" != 0 ] || return 0
  [ -z "${DARWINOP_NO_ASLR:-}" ] || launch="setarch -R $launch"
  failed_in "$log" | while read -r test; do
    say "to repeat: ${launch}ctest --preset $preset -R '^$test\$'"
  done
  return "$status"
}

failed_in() { # LOG: names of the tests that failed
  sed -n '/^The following tests FAILED/,$ { /(Skipped)$/d; s/^\t *[0-9]* - \(.*\) (.*/\1/p; }' "$1"
}

# run_side_by_side PRESET [ARGUMENT...]: as run_tests, but processes in real time that fail beside others get two more
# tries: a computer that others keep busy misses limits of seconds. All other failures are final.
in_real_time='^(slow|browser|python|installer)$'  # labels
run_side_by_side() {
  run_tests "$@" && return
  [ -n "$(failed_in "build/$1.log")" ] || return 1
  ctest --preset "$1" -N -L "$in_real_time" | sed -n 's/^ *Test *#[0-9]*: //p' >"build/$1.waiting"
  ! failed_in "build/$1.log" | grep -qvxFf "build/$1.waiting" || return 1
  try_again "$1" 2
}

# measure_tests PRESET: tests that measure real time, one at a time. Those that fail get four more tries: the host of a
# virtual machine may take its processors away for milliseconds (steal in /proc/stat), and then the program rightly reports
# late cycles.
measure_tests() { run_tests "$1" || try_again "$1" 4; }

# try_again PRESET TIMES: what failed, one at a time with the background stopped, until it passes. What a sanitizer reports is
# final: it may not come again.
try_again() {
  local status=0
  ! sanitizer_reported "$1" || return 1
  failed_in "build/$1.log" >"build/$1.again"
  say "once more, with nothing in the background; time taken away so far: $(stolen_ms) ms"
  background_is STOP
  run_tests "$1" --rerun-failed --repeat "until-pass:$2" || status=$?
  background_is CONT
  say "time taken away now: $(stolen_ms) ms"
  ! sanitizer_reported "$1" || return 1
  [ "$status" != 0 ] || sed "s/^/passed at a later try ($1): /" "build/$1.again" >>"build/$1.summary"
  return "$status"
}
sanitizer_reported() { grep -qE '(ERROR|WARNING): [A-Za-z]*Sanitizer|runtime error:' "build/$1.log"; }
stolen_ms() { awk -v hz="$(getconf CLK_TCK)" '$1 == "cpu" { print int(1000 * $9 / hz) }' /proc/stat; }
background_is() { [ -z "${DARWINOP_AHEAD:-}" ] || kill "-$1" -- "-$DARWINOP_AHEAD" 2>/dev/null || :; } # STOP|CONT
