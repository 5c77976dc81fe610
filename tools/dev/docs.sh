#!/usr/bin/env bash
# Renews the pages of docs/ that are generated from tables.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/dev/build.sh

build debug print_registers print_faults print_effects draw_gait
build/debug/bin/print_registers >docs/registers.md
faults=$(build/debug/bin/print_faults docs/faults.md) && printf '%s\n' "$faults" >docs/faults.md
build/debug/bin/print_effects >docs/twin/effects.md
build/debug/bin/draw_gait docs/gait
tools/print_rooms.sh --write
build_hazard_tests debug
tools/check_hazards.sh build/debug --write
text=$(sed '/^<!-- packages -->$/q' docs/dependencies.md)
{ printf '%s\n' "$text" && ./dev help packages; } >docs/dependencies.md
