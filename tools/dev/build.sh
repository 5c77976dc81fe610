# shellcheck shell=bash
# Builds CMake presets. Sourced from the top folder of the repository.
. tools/dev/install.sh

# build PRESET [TARGET...]. DARWINOP_WINDOW=ON: fail when npm cannot get the packages of the robot window;
# DARWINOP_PYTHON=ON: when pybind11 or Python's headers are missing.
build() {
  local preset=$1 folder=build/${1%-tests} launcher=() quiet=() options
  shift
  # From an empty cache, ccache only costs time.
  if command -v ccache >/dev/null && { [ "${CI:-}" != true ] || [ -d "${CCACHE_DIR:-$HOME/.cache/ccache}" ]; }; then
    launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1  # clones share what they compiled
    export CCACHE_SLOPPINESS=pch_defines,time_macros  # without these, ccache ignores what uses precompiled headers
  fi
  [ -t 1 ] || quiet=(--quiet)
  await_ahead "$preset"
  say "building preset $preset ${*:+($*)}"
  options=(--preset "$preset" "${launcher[@]}" -DDARWINOP_WINDOW="${DARWINOP_WINDOW:-AUTO}"
    -DDARWINOP_PYTHON="${DARWINOP_PYTHON:-AUTO}")
  mkdir -p "$folder"
  (
    flock 9  # a stage in the background may use the same folder
    configure "$folder" "${options[@]}" || die "cmake could not configure preset $preset"
    ninja -C "$folder" "${quiet[@]}" "$@"
  ) 9>"$folder/lock"
}

# Runs cmake unless it has run with the same options, presets and commit: ninja itself sees everything else.
configure() { # FOLDER OPTION...
  local folder=$1 wanted
  shift
  wanted="$* $(cksum <CMakePresets.json) $(git describe --always --dirty --exclude '*' 2>/dev/null)"
  if [ -e "$folder/build.ninja" ] && [ "$(cat "$folder/configured" 2>/dev/null)" = "$wanted" ]; then return; fi
  mkdir -p "$folder"
  rm -f "$folder/configured"
  cmake "$@" >"$folder/configure.log" 2>&1 || {
    cat "$folder/configure.log"
    return 1
  }
  echo "$wanted" >"$folder/configured"
}

# await_ahead PRESET: waits until the background process (tools/test/background.sh) has built it, at full speed meanwhile.
await_ahead() {
  # Not in that process itself.
  [ -e "build/ahead/$1" ] && [ "${DARWINOP_AHEAD:-$BASHPID}" != "$BASHPID" ] || return 0
  ahead_at --other
  while [ -e "build/ahead/$1" ] && kill -0 "$DARWINOP_AHEAD" 2>/dev/null; do sleep 0.2; done
  ahead_at --idle
}
# The session also has a share of the processors, by its nice value (sched_autogroup); only root may lower it.
ahead_at() { # --idle|--other
  pgrep -g "$DARWINOP_AHEAD" | xargs -r -n 1 chrt "$1" --pid 0 2>/dev/null || :
  { [ "$1" = --idle ] && echo 19 || echo 0; } 2>/dev/null >"/proc/$DARWINOP_AHEAD/autogroup" || :
}

# The archive that `darwinop install` sends and the SDK that controllers for the robot are built with.
build_robot() { # ARCHITECTURE
  local preset=robot
  [ "$1" = i686 ] || preset=robot-$1
  build "$preset" robot_programs darwinop_sdk
  tools/make_bundle.sh "build/$preset"
}

# sources PATTERN...: files of the repository, including new ones.
sources() {
  git ls-files --cached --others --exclude-standard --deduplicate -- "$@" | while read -r file; do
    if [ -e "$file" ]; then echo "$file"; fi
  done
}
