#!/usr/bin/env bash
# Installs the robot's SDK to a place of its own and builds a controller with it in both ways that are promised; the
# programs have to be static ones for the robot's computer, and to run.
#   cross_compiled_controllers.sh BUILD_DIRECTORY SOURCE_DIRECTORY ARCHITECTURE [EMULATOR]
set -euo pipefail
build=$1
source=$2
architecture=$3
emulator=${4:-}
case $architecture in i686) machine=3 ;; amd64) machine=62 ;; armhf) machine=40 ;; aarch64) machine=183 ;; esac
: "${CMAKE:=cmake}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# What a developer may have set for programs of the PC must not matter.
export CXX=false

"$CMAKE" --install "$build" --component sdk --prefix "$work/sdk" >"$work/log"

judge() { # PROGRAM
  local kind
  kind=$(od -An -tu1 -j18 -N1 "$1" | tr -d ' ')
  [ "$kind" = "$machine" ] || { echo "$1 is not a program for $architecture"; exit 1; }
  if grep -aq '/ld-linux' "$1"; then echo "$1 needs a loader on the robot"; exit 1; fi
  # shellcheck disable=SC2086  # no word without an emulator
  if ! DARWINOP_ROBOT=virtual $emulator "$1" --seconds 2 >"$work/out" 2>&1; then
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

echo "== cmake with toolchain/$architecture-linux.cmake"
"$CMAKE" -S "$source/controllers/01_hello_head" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/sdk" \
  -DCMAKE_TOOLCHAIN_FILE="$source/toolchain/$architecture-linux.cmake" >>"$work/log"
"$CMAKE" --build "$work/cmake" >>"$work/log" || { cat "$work/log"; exit 1; }
judge "$work/cmake/01_hello_head"

echo "both ways work"
