# shellcheck shell=bash
# Builds CMake presets. Sourced from the top folder of the repository.
. tools/dev/install.sh

# build PRESET [TARGET...]. DARWINOP_WINDOW=ON: fail when npm cannot get the packages of the robot window.
build() {
  local preset=$1 launcher=() quiet=()
  shift
  if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1  # clones share what they compiled
    export CCACHE_SLOPPINESS=pch_defines,time_macros  # without these, ccache ignores what uses precompiled headers
  fi
  [ -t 1 ] || quiet=(--quiet)
  mkdir -p build
  await_ahead "$preset"
  say "building preset $preset ${*:+($*)}"
  cmake --preset "$preset" "${launcher[@]}" -DDARWINOP_WINDOW="${DARWINOP_WINDOW:-AUTO}" >"build/$preset.configure.log" 2>&1 || {
    cat "build/$preset.configure.log"
    die "cmake could not configure preset $preset"
  }
  ninja -C "build/$preset" "${quiet[@]}" "$@"
}

# Waits until the background build of a preset (tools/test/run.sh) is done. If that failed, build() repeats it and shows why.
await_ahead() { # PRESET
  while [ -e "build/ahead/$1" ] && kill -0 "${DARWINOP_AHEAD:-none}" 2>/dev/null; do sleep 0.2; done
}

# The archive that `darwinop install` sends and the SDK that controllers for the robot are built with.
build_robot() {
  build robot robot_programs darwinop_sdk
  tools/make_bundle.sh build/robot
}

# sources PATTERN...: files of the repository, including new ones.
sources() {
  git ls-files --cached --others --exclude-standard --deduplicate -- "$@" | while read -r file; do
    if [ -e "$file" ]; then echo "$file"; fi
  done
}

# Programs whose tests the hazard table names: build_hazard_tests PRESET
build_hazard_tests() {
  local tests
  build "$1" print_hazards
  mapfile -t tests < <("build/$1/bin/print_hazards" --programs | cut -d ' ' -f 1)
  build "$1" "${tests[@]}"
}
