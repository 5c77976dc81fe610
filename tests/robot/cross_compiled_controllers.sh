#!/usr/bin/env bash
# Installs the robot's SDK to a place of its own and builds a controller with it in both ways that are promised; the
# programs have to be static ones for a 32-bit machine, and to run.
#   cross_compiled_controllers.sh BUILD_DIRECTORY SOURCE_DIRECTORY
set -euo pipefail
build=$1
source=$2
: "${CMAKE:=cmake}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# What a developer may have set for programs of the PC must not matter.
export CXX=false

"$CMAKE" --install "$build" --component sdk --prefix "$work/sdk" >"$work/log"

judge() { # PROGRAM
  local kind
  kind=$(od -An -tu1 -j4 -N1 "$1" | tr -d ' ')
  [ "$kind" = 1 ] || { echo "$1 is not a 32-bit program"; exit 1; }
  if grep -aq '/ld-linux' "$1"; then echo "$1 needs a loader on the robot"; exit 1; fi
  if ! DARWINOP_ROBOT=virtual "$1" --seconds 2 >"$work/out" 2>&1; then
    echo "$1 ended badly:"
    cat "$work/out"
    exit 1
  fi
}

echo "== make -f Makefile.darwin-op"
cp -r "$source/controllers/02_symmetry" "$work/symmetry"
echo 'include ../Makefile.include' >"$work/symmetry/Makefile.darwin-op"
ln -s "$work/sdk/share/darwinop/Makefile.include" "$work/Makefile.include"
make -s -C "$work/symmetry" -f Makefile.darwin-op
judge "$work/symmetry/symmetry"

echo "== cmake with toolchain/i686-linux.cmake"
"$CMAKE" -S "$source/controllers/01_hello_head" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/sdk" \
  -DCMAKE_TOOLCHAIN_FILE="$source/toolchain/i686-linux.cmake" >>"$work/log"
"$CMAKE" --build "$work/cmake" >>"$work/log" || { cat "$work/log"; exit 1; }
judge "$work/cmake/01_hello_head"

echo "both ways work"
