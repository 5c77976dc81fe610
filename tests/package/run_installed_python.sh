#!/bin/bash
# Installs the commands to a place of its own, goes somewhere else, and runs a controller in Python.
#   run_installed_python.sh BUILD_DIRECTORY SOURCE_DIRECTORY
set -euo pipefail
build=$1
source=$2
: "${CMAKE:=cmake}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

# The prefix is moved after the install: nothing in it may remember where it was.
"$CMAKE" --install "$build" --component commands --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/prefix"
cp -r "$source/tests/python/controllers/walk" "$work/walk"
cp "$source/controllers/05_walk/config.ini" "$work/walk"
cd /

# The dynamic linker prints which files it opened, so that the extension of the build folder would show.
export PYTHONDONTWRITEBYTECODE=1 LD_DEBUG=files LD_DEBUG_OUTPUT=$work/opened
"$work/prefix/bin/darwinop" run --robot virtual "$work/walk" --seconds 1 >"$work/run.txt" 2>&1 ||
  { cat "$work/run.txt"; fail "the controller"; }
unset LD_DEBUG LD_DEBUG_OUTPUT
grep -qx 'stands: True' "$work/run.txt" || { cat "$work/run.txt"; fail "it does not stand"; }
opened=$(sed -nE 's/.*file=([^ ]*_darwinop\.[^ ]*\.so).*/\1/p' "$work"/opened.* | sort -u)
[ "$opened" = "$(find "$work/prefix" -name '_darwinop.*.so')" ] || fail "the extension that was loaded: $opened"
echo "the installed Python modules work"
