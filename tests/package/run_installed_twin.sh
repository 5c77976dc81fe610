#!/bin/bash
# Installs the commands and the twin to a place of its own, goes somewhere else, and uses them.
#   run_installed_twin.sh BUILD_DIRECTORY
set -euo pipefail
build=$1
: "${CMAKE:=cmake}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
step() { echo "== $*"; }

# The prefix is moved after the install: nothing in it may remember where it was.
step "install"
for component in commands twin; do
  "$CMAKE" --install "$build" --component "$component" --prefix "$work/first" >>"$work/install.log"
done
mv "$work/first" "$work/prefix"
prefix=$work/prefix
cp "$build/controllers/02_symmetry/02_symmetry" "$work/controller"  # far from the build's library
mkdir "$work/elsewhere"
cd "$work/elsewhere"

# The dynamic linker prints which files it opened, and what looks for models and experiments takes its own folder first:
# so a file of the build folder that is used shows, although it is there.
step "darwinop-run --robot twin"
LD_DEBUG=files LD_DEBUG_OUTPUT="$work/opened" "$prefix/bin/darwinop-run" --robot twin "$work/controller" --seconds 1 \
  >"$work/run.txt" 2>&1 || { cat "$work/run.txt"; fail "the controller"; }
grep -q '^report: ' "$work/run.txt" || fail "no report"
opened=$(sed -nE 's/.*file=([^ ]*libdarwinop-twin\.so).*/\1/p' "$work"/opened.* | sort -u)
[ "$opened" = "$(find "$prefix" -name libdarwinop-twin.so)" ] || fail "the twin that was loaded: $opened"

step "darwinop twin models"
"$prefix/bin/darwinop" twin models | tee "$work/models.txt"
for model in darwin-op webots-2013; do
  grep -qx " *$prefix/share/darwinop/models/$model.ini" "$work/models.txt" || fail "model $model"
done
[ -e "$prefix/share/darwinop/models/darwin-op.xml" ] || fail "the body's file"

step "darwinop experiment list"
"$prefix/bin/darwinop" experiment list >"$work/experiments.txt"
grep -qx damping "$work/experiments.txt" || fail "the experiments"
[ -e "$prefix/share/darwinop/experiments/damping.ini" ] || fail "an experiment's file"

step "darwinop twin view"
"$prefix/bin/darwinop" twin view --record "$work/film" --seconds 0.2 --fps 10 --size 64x48
[ "$(ls "$work/film")" = "$(printf 'frame_0000%d.png\n' 1 2)" ] || fail "the film: $(ls "$work/film")"

[ -z "$(ls)" ] || fail "left behind: $(ls)"
echo "the installed twin works"
