#!/usr/bin/env bash
# Starts a virtual robot, drives it with an example for 10 s and prints the loop report; its last line is for scripts.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh

build release darwinop darwinop-run darwinop-virtual-robot 01_hello_head
folder=$(mktemp -d)
robot=$folder/robot
status=0
build/release/bin/darwinop-virtual-robot --link "$robot" >"$folder/log" 2>&1 &
virtual_robot=$!
trap 'kill "$virtual_robot" 2>/dev/null; wait "$virtual_robot" 2>/dev/null; rm -rf "$folder"' EXIT
for _ in $(seq 100); do
  [ -e "$robot" ] && break
  sleep 0.05
done
[ -e "$robot" ] || { cat "$folder/log" && die "the virtual robot did not start"; }
say "a virtual robot, a CM-730 and 20 MX-28 paced at 1 Mbaud, stands at $(readlink "$robot")"
say "controllers/01_hello_head drives it for 10 s, one cycle every 16 ms"
build/release/bin/darwinop-run --robot "$robot" --period 16 build/release/controllers/01_hello_head --seconds 10 |
  tee "$folder/out" | grep --line-buffered -v '^report: ' || status=${PIPESTATUS[0]}
[ "$status" = 0 ] || die "the controller ended with status $status"
cat <<'END'

What to try next:
  eval "$(./dev env)"                             # the darwinop commands on your PATH
  darwinop virtual-robot --link /tmp/darwin &     # a virtual robot that stays
  darwinop doctor --robot /tmp/darwin             # checks the robot, with a fix for each finding
  cat controllers/01_hello_head/01_hello_head.cpp # a controller is one file
  ./dev test                                      # the tests that the maintainers run

END
grep '^report: ' "$folder/out"
