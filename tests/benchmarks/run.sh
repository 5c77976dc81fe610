#!/usr/bin/env bash
# Runs benchmarks and prints each figure as "bench: NAME ours=... peer=... ratio=... unit=...".
# usage: run.sh BUILD_FOLDER [NAME [WORDS FOR IT ...]]
set -euo pipefail

build=$1
wanted=${2:-}
words=("${@:3}")
folder=$(mktemp -d)
virtual_robot=
cleanup() {
  [ -z "$virtual_robot" ] || kill "$virtual_robot" 2>/dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT

# bench NAME OURS PEER UNIT
bench() { awk -v n="$1" -v o="$2" -v p="$3" -v u="$4" \
  'BEGIN { printf "bench: %s ours=%s peer=%s ratio=%.3f unit=%s\n", n, o, p, o / p, u }'; }

# --- CPU instructions a cycle: the same on every machine, loaded or not

# instructions KIND SERVOS: of one cycle, without those of the far end of the line.
instructions() {
  local log=$folder/callgrind
  valgrind --tool=callgrind --collect-atstart=no --toggle-collect='darwinop::bench::ReplayLine::*' \
    --callgrind-out-file=/dev/null "$build/bin/cycle_instructions" "$1" "$2" >"$log" 2>&1 || { cat "$log" >&2; return 1; }
  sed -nE 's/.*Collected *: *([0-9]+).*/\1/p' "$log" | awk '{ printf "%d", $1 / 320 }'
}

# compare_instructions NAME KIND PEER_KIND SERVOS; leaves the figure in $ours.
compare_instructions() {
  local peer
  ours=$(instructions "$2" "$4")
  peer=$(instructions "$3" "$4")
  bench "$1" "$ours" "$peer" instructions
}

# within_limit NAME FIGURE LIMIT: fails above the limit, and more than 5 % below it, where a loss would go unnoticed.
within_limit() {
  if (($2 > $3)); then
    echo "$1: $2 instructions, the limit is $3; look for the cause with callgrind_annotate" >&2
    return 1
  fi
  if (($2 * 100 < $3 * 95)); then
    echo "$1: $2 instructions, more than 5 % below the limit of $3; lower the limit in $0" >&2
    return 1
  fi
}

# Peer: a plain wrapper that does the same traffic without safety, ages, statistics or a second thread.
# The limits hold for preset bench on amd64, with g++ 12.
cycle_instructions() {
  local n ours limit=([5]=13700 [10]=15900 [20]=20000) kept=0
  for n in 5 10 20; do
    compare_instructions "cycle_instructions_$n" loop plain $n
    within_limit "cycle_instructions_$n" "$ours" "${limit[n]}" || kept=1
  done
  return $kept
}

# Peer: the packet handling of that wrapper. 30 servos: as many as fit with goals alone.
codec_instructions() {
  local n ours
  for n in 5 10 20 30; do compare_instructions "codec_instructions_$n" codec plain-goals $n; done
}

# --- CPU time a cycle

cycle_time() {
  local n figures=$folder/cycle_time
  "$build/bin/cycle_time" --benchmark_format=csv 2>/dev/null | sed -n '/^name,/,$p' | tr -d '"' >"$figures"
  time_of() { awk -F, -v name="$1" '$1 ~ "^" name "(/iterations.*)?$" { printf "%.0f", $4 }' "$figures"; }
  for n in 5 10 20; do bench "cycle_time_$n" "$(time_of "loop/$n")" "$(time_of "plain/$n")" ns; done
  for n in 5 10 20 30; do bench "codec_time_$n" "$(time_of "codec/$n")" "$(time_of "plainGoals/$n")" ns; done
}

# --- on a real pty, paced at 1 Mbaud

start_virtual_robot() {
  [ -z "$virtual_robot" ] || return 0
  "$build/bin/darwinop-virtual-robot" --link "$folder/robot" >"$folder/log" 2>&1 &
  virtual_robot=$!
  for _ in $(seq 100); do
    [ ! -e "$folder/robot" ] || return 0
    sleep 0.05
  done
  cat "$folder/log" >&2
  return 1
}

# run_loop PERIOD_MS: drives the virtual robot for 20 s; leaves the report line in $folder/report.
run_loop() {
  start_virtual_robot
  "$build/bin/darwinop-run" --robot "$folder/robot" --period "$1" \
    "$build/controllers/01_hello_head/01_hello_head" --seconds 20 >"$folder/out" 2>&1 || { cat "$folder/out" >&2; return 1; }
  grep '^report: ' "$folder/out" | tee "$folder/report"
}
figure() { sed -nE "s/.* $1=([^ ]+).*/\1/p" "$folder/report"; }

# Peer: the wire itself, which no program can beat.
bus_overhead() {
  local period
  for period in 16 8; do
    run_loop $period
    bench "bus_overhead_${period}ms" "$(figure bus_ms_median)" "$(figure wire_ms)" ms
  done
}

# Peer: cyclictest in the same seconds, at the same priority and period.
wake_latency() {
  if ! command -v cyclictest >/dev/null; then
    echo "wake_latency: cyclictest is not installed" >&2
    return 1
  fi
  local period=16 q
  start_virtual_robot
  cyclictest --mlockall --priority=80 --interval=$((period * 1000)) --loops=1250 --histogram=50000 --quiet \
    >"$folder/cyclictest" 2>/dev/null &
  local tester=$!
  run_loop $period
  wait $tester || { echo "cyclictest may not use real-time priority here" >&2; return 1; }
  quantile() {
    awk -v q="$1" '/^[0-9]+ [0-9]+$/ { n[++rows] = $2; us[rows] = $1; total += $2 }
      END { for (i = 1; i <= rows; i++) if ((seen += n[i]) >= q * total) { print us[i] + 1; exit } }' "$folder/cyclictest"
  }
  for q in 50 99; do
    bench "wake_latency_p$q" "$(figure wake_p${q}_us)" "$(quantile 0.$q)" us
  done
  bench wake_latency_max "$(figure wake_max_us)" "$(quantile 1)" us
}

# --- the physics twin

# Simulated seconds per second of CPU time. Peers: a loop written by hand for this one case, and MuJoCo's hinge.
twin_bench() { "$build/bin/twin_bench_rate"; }

# CPU time of a simulated millisecond of the whole body, and how many times real time that is. Peer: the plain step of
# the same MuJoCo body. Best of several turns: whatever else runs on the machine only makes them slower.
twin_body() {
  local pose ours peer figures=$folder/twin_body
  "$build/bin/twin_body_rate" --benchmark_format=csv --benchmark_min_time=0.2 --benchmark_repetitions=8 \
    --benchmark_enable_random_interleaving=true 2>"$folder/log" >"$figures" || { cat "$folder/log" >&2; return 1; }
  if grep -q '"the robot fell over"' "$figures"; then echo "twin_body: the robot fell over" >&2; return 1; fi
  best_of() {
    tr -d '"' <"$figures" | awk -F, -v name="$1" '$1 == name && (!best || $4 < best) { best = $4 }
      END { printf "%.2f", best / 1000 }'
  }
  for pose in kneeling standing squatting squatting_webots_2013; do
    ours=$(best_of "ours/$pose")
    peer=$(best_of "plain/$pose")
    bench "twin_body_$pose" "$ours" "$peer" us
    bench "twin_body_${pose}_rate" "$(awk "BEGIN { printf \"%.1f\", 1000 / $ours }")" \
      "$(awk "BEGIN { printf \"%.1f\", 1000 / $peer }")" s/s
  done
}

# --- darwinop gap

# Roll-outs, scaling with threads and logs; peer: a global optimiser on the same data. Minutes.
gap() {
  local part
  for part in rollout scaling peer; do "$build/bin/gap_bench" "$part"; done
}

# The whole robot: roll-outs, scaling with joints, logs, cores and ranks; peer: the plain way. Minutes.
gap_body() {
  local part
  for part in rollout scaling plain; do "$build/bin/gap_body_bench" "$part"; done
  gap_body_ranks
}

# Four cases with two ranks; peer: one.
gap_body_ranks() {
  local cases=$folder/body_cases n begin
  local -a seconds effects=(--effect coulomb --effect none --effect backlash@pair --effect none)
  "$build/bin/darwinop-gap" benchmark make --family body "${effects[@]}" --seed 7 --out "$cases" >/dev/null
  for n in 1 2; do
    begin=$(date +%s.%N)
    tests/gap/benchmark/run/mpi.sh $n "$build/bin/darwinop-gap" benchmark run --threads 1 "$cases/cases" \
      --out "$folder/ranks_$n.json" >/dev/null
    seconds[n]=$(awk -v b="$begin" -v e="$(date +%s.%N)" 'BEGIN { printf "%.1f", e - b }')
  done
  bench gap_body_suite_2_ranks_over_1 "${seconds[2]}" "${seconds[1]}" s
}

# --- the vision manager

# CPU time of a picture; peers: OpenCV's steps, and plain ones a pixel at a time.
vision() { "$build/bin/vision_bench"; }

# --- the walking engine

# gait_call PROGRAM ours|plain: instructions of one call.
gait_call() {
  local calls counted=()
  for calls in 1000 4000; do
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" "$calls" >"$folder/gait" 2>&1 ||
      { cat "$folder/gait" >&2; return 1; }
    counted+=("$(sed -nE 's/.*Collected *: *([0-9]+).*/\1/p' "$folder/gait")")
  done
  echo $(((counted[1] - counted[0]) / 3000))
}

# One call, 8 ms of walking. Peer: the published algorithm written down as it reads, with the same ticks. Time here;
# instructions here and, when it has been built, of the robot's program.
gait() {
  local ours peer program robot=$build/../robot/bin/gait_instructions
  "$build/bin/gait_time" --benchmark_format=csv --benchmark_min_time=0.1 --benchmark_repetitions=10 \
    --benchmark_enable_random_interleaving=true 2>"$folder/log" | tr -d '"' >"$folder/gait_time" ||
    { cat "$folder/log" >&2; return 1; }
  best_call() { awk -F, -v name="$1" '$1 == name && (!best || $4 < best) { best = $4 } END { printf "%.0f", best }' \
    "$folder/gait_time"; }
  bench gait_time "$(best_call ours)" "$(best_call plain)" ns
  for program in "$build/bin/gait_instructions" "$robot"; do
    [ -x "$program" ] || { echo "gait: without the robot's instructions, there is no $robot" >&2; continue; }
    "$program" check 1 || { echo "gait: the two gaits of $program are not the same" >&2; return 1; }
    ours=$(gait_call "$program" ours)
    peer=$(gait_call "$program" plain)
    if [ "$program" = "$robot" ]; then bench gait_instructions_i686 "$ours" "$peer" instructions
    else bench gait_instructions "$ours" "$peer" instructions; fi
  done
}

# --- the camera

# YUYV to BGRA by each kernel that this CPU has, and to planes. Peers: libyuv, five passes, and memcpy, which is the limit.
camera() { "$build/bin/camera_bench"; }

# The SIMD kernels of camera and vision. Peer: the same written with Highway, at the same instruction set.
highway() { "$build/bin/highway_bench"; }

# The picture in a reply, from YUYV to bytes and back. Peers: libjpeg from BGRA, the same and as in 2013; raw bytes.
remote_jpeg() { "$build/bin/remote_jpeg_bench"; }

# The same as a table.
remote_table() { "$build/bin/remote_jpeg_bench" table; }

# Finding colours in a picture for the monitor's observers, one and eight. Peer: the picture's JPEG.
monitor_find() { "$build/bin/monitor_find"; }

# Wake latency of the loop while the port is attacked, in real processes: 3 minutes. Peer: the same while nobody comes.
remote_flood() { "$build/bin/remote_flood" "$build/bin" "${DARWINOP_FLOOD_ROUNDS:-12}"; }

# Round trips over slow networks, as a table. Needs root, for networks of its own.
remote_link() { "$build/bin/remote_link"; }

# A whole poll and its reply over the loopback. Peer: the same bytes both ways, without a server.
remote_round_trip() { "$build/bin/remote_round_trip"; }

# --- the robot window

# Frames a second and memory, in a browser: [SECONDS [TAB]], an hour shows whether it grows. Peers: the screen, itself before.
window() {
  DARWINOP_BIN=$(realpath "$build/bin") DARWINOP_NPM=$(realpath "$build/../npm/node_modules") \
    node "$(dirname "$0")/robot_window.mjs" "${words[@]}"
}

all=(cycle_instructions codec_instructions cycle_time bus_overhead wake_latency twin_bench twin_body gap gap_body camera highway vision remote_jpeg remote_table monitor_find remote_round_trip remote_flood
  remote_link gait window)
for name in "${all[@]}"; do
  [ -z "$wanted" ] || [ "$wanted" = "$name" ] || continue
  "$name"
  ran=yes
done
[ -n "${ran:-}" ] || { echo "no benchmark '$wanted'; there are: ${all[*]}" >&2; exit 1; }
