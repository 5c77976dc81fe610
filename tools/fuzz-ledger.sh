#!/usr/bin/env bash
# The fuzz ledger: what libFuzzer has done for each decoder, summed over all runs. It is a text file, one row a fuzzer,
# columns separated by tabs: fuzzer, executions, core seconds, edges, features, last finding, commit and date of the last run.
#
#   fuzz-ledger.sh run LEDGER SECONDS   gives every fuzzer of build/fuzz/bin this many more core seconds, round robin, and
#                                       adds each slice to LEDGER as soon as it ends; stop it at any time, nothing is lost
#   fuzz-ledger.sh deep SECONDS         the same with tests/fuzz/ledger.tsv, then renews the table of docs/fuzzing.md
#   fuzz-ledger.sh add LEDGER OTHER     adds the sums of a ledger that was kept elsewhere (once)
#   fuzz-ledger.sh print                the table of docs/fuzzing.md
#
# Environment of `run` and `deep`: FUZZ_BUILD (build/fuzz: has bin/, gets corpus/, found/ and logs), FUZZ_SLICE (120: longest slice
# in seconds), FUZZ_COMMIT (that of the sources; default: HEAD).
set -euo pipefail
work=$PWD
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

usage() {
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' tools/fuzz-ledger.sh >&2
  exit 2
}
absolute() { case $1 in /*) echo "$1" ;; *) echo "$work/$1" ;; esac; }

# merge LEDGER ROW...: adds rows to LEDGER. Counts are summed; coverage, commit and date are those of the newest row, the
# finding is the newest that there is. LEDGER is replaced in one step, so an interruption leaves the old or the new one.
merge() {
  local ledger=$1
  shift
  (
    flock 9
    touch "$ledger"
    { cat "$ledger" && printf '%s\n' "$@"; } | awk -F '\t' -v OFS='\t' '
      /^#/ || NF < 8 { next }
      {
        executions[$1] += $2
        seconds[$1] += $3
        if (!($1 in date) || $8 >= date[$1]) { edges[$1] = $4; features[$1] = $5; commit[$1] = $7; date[$1] = $8 }
        if (!($1 in finding) || ($6 != "-" && (finding[$1] == "-" || $6 > finding[$1]))) finding[$1] = $6
      }
      END {
        for (f in date) printf "%s\t%d\t%d\t%d\t%d\t%s\t%s\t%s\n", f, executions[f], seconds[f], edges[f], features[f], finding[f], commit[f], date[f]
      }' | LC_ALL=C sort >"$ledger.new"
    {
      printf '# fuzzer\texecutions\tcore seconds\tedges\tfeatures\tlast finding\tcommit\tdate\n'
      cat "$ledger.new"
    } >"$ledger.newer"
    rm "$ledger.new"
    mv "$ledger.newer" "$ledger"
  ) 9<"$(dirname "$ledger")"
}

# Sets $spent: processor time of all programs that have ended, in hundredths of a second. A subshell would have its own.
count_spent() {
  times >"$build/times"
  spent=$(tail -1 "$build/times" | tr 'ms' '  ' | awk '{ printf "%d", ($1 * 60 + $2 + $3 * 60 + $4) * 100 }')
}

build=
spent=0
fuzzing=
stopped=
stop() {
  stopped=1
  [ -z "$fuzzing" ] || kill -INT "$fuzzing" 2>/dev/null || :
}

# is_slow NAME INPUT: libFuzzer measures real time, and a busy or suspended machine makes any input slow. More than 2 core
# seconds are a finding.
is_slow() {
  local before
  count_spent
  before=$spent
  "$build/bin/$1" "$2" >/dev/null 2>&1 || return 0
  count_spent
  [ $((spent - before)) -gt 200 ]
}

# slice NAME SECONDS: one run of a fuzzer. Sets $used (hundredths of a core second); returns 1 when it found something.
slice() {
  local name=$1 seconds=$2 log=$build/$1.log status=0 before executions coverage artifact finding=-
  mkdir -p "$build/corpus/$name" "$build/found"
  local folders=("$build/corpus/$name")
  [ ! -d "tests/fuzz/corpus/$name" ] || folders+=("tests/fuzz/corpus/$name")
  count_spent
  before=$spent
  "$build/bin/$name" -max_total_time="$seconds" -print_final_stats=1 -max_len=4096 -artifact_prefix="$build/found/$name-" \
    "${folders[@]}" >/dev/null 2>"$log" </dev/null &
  fuzzing=$!
  while :; do  # a signal ends wait, not the fuzzer
    status=0
    wait "$fuzzing" || status=$?
    kill -0 "$fuzzing" 2>/dev/null || break
  done
  fuzzing=
  count_spent
  used=$((spent - before))
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)
  coverage=$(grep -oE 'cov: [0-9]+ ft: [0-9]+' "$log" | tail -1 | awk '{ print $2 "\t" $4 }')
  artifact=$(sed -n 's/^.*Test unit written to //p' "$log" | tail -1)
  if [[ ${artifact##*/} == "$name"-slow-unit-* ]] && ! is_slow "$name" "$artifact"; then
    rm "$artifact"
    artifact=
    status=0
  fi
  if [ -n "$artifact" ]; then
    finding="$(date -u +%F) ${artifact##*/"$name"-}"
  elif [ "$status" != 0 ] && [ -z "$stopped" ]; then
    tail -40 "$log" >&2
    echo "fuzz-ledger: $name ended with status $status; see $log" >&2
    return 1
  fi
  [ -z "$coverage" ] || merge "$ledger" "$(printf '%s\t%s\t%s\t%s\t%s\t%s\t%s' "$name" "${executions:-0}" \
    "$(((used + 50) / 100))" "$coverage" "$finding" "$commit" "$(date -u +%FT%TZ)")"
  echo "fuzz-ledger: $name: ${executions:-0} executions in $((used / 100)) core seconds, $(echo "$coverage" | tr '\t' '/') edges/features"
  [ "$finding" = - ] || {
    tail -40 "$log" >&2
    echo "fuzz-ledger: $name found something; the input is $artifact" >&2
    return 1
  }
}

run() {
  ledger=$(absolute "$1")
  local goal=$(($2 * 100)) longest=${FUZZ_SLICE:-120} name fuzzer rest seconds failed=0 busy=1
  local -A done_of=()
  build=$(absolute "${FUZZ_BUILD:-$PWD/build/fuzz}")
  commit=${FUZZ_COMMIT:-$(git rev-parse --short HEAD)}
  trap stop INT TERM HUP
  while [ "$busy" = 1 ]; do
    busy=0
    for fuzzer in "$build"/bin/*_fuzz; do
      [ -x "$fuzzer" ] || { echo "fuzz-ledger: no fuzzer in $build/bin" >&2; exit 2; }
      name=${fuzzer##*/}
      rest=$((goal - ${done_of[$name]:-0}))
      [ $((rest * 10)) -gt "$goal" ] || continue  # a tenth less is near enough, a slice for a rest would mostly read inputs
      seconds=$(((rest + 99) / 100))
      [ "$seconds" -le "$longest" ] || seconds=$longest
      busy=1
      used=0
      slice "$name" "$seconds" || { failed=1 && used=$goal; }  # not again in this run: it would find the same
      [ -z "$stopped" ] || exit 130
      done_of[$name]=$((${done_of[$name]:-0} + used))
    done
  done
  exit $failed
}

deep() {
  trap 'tools/pages.sh write . docs/fuzzing.md' EXIT  # however it ends
  run "$PWD/tests/fuzz/ledger.tsv" "$1"
}

add() {
  local rows=()
  mapfile -t rows < <(grep -v '^#' "$(absolute "$2")")
  merge "$(absolute "$1")" "${rows[@]}"
}

# What a fuzzer checks: the first line of its source.
purpose() { sed -n '1s/^\/\/ //p' "$1" | sed 's/|/\\|/g'; }

print() {
  local ledger=tests/fuzz/ledger.tsv source name
  printf '| fuzzer | executions | core hours | edges | features | last finding | commit | what it checks |\n'
  printf '|---|---:|---:|---:|---:|---|---|---|\n'
  for source in tests/fuzz/*_fuzz.cpp; do
    name=$(basename "$source" .cpp)
    awk -F '\t' -v name="$name" -v purpose="$(purpose "$source")" '
      $1 == name { executions = $2; seconds = $3; edges = $4; features = $5; finding = $6; commit = $7 }
      END {
        printf "| `%s` | %d | %.2f | %d | %d | %s | %s | %s |\n", name, executions, seconds / 3600, edges, features, finding == "-" || finding == "" ? "none" : finding, commit == "" ? "-" : commit, purpose
      }' "$ledger"
  done
  awk -F '\t' '!/^#/ { executions += $2; seconds += $3; n += 1 } END { printf "| all %d | %d | %.2f | | | | | |\n", n, executions, seconds / 3600 }' "$ledger"
}

case ${1:-}:$# in
  run:3 | deep:2 | add:3 | print:1) "$@" ;;
  *) usage ;;
esac
