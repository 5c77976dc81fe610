# shellcheck shell=sh
# Builds a controller for the robot's processor on this PC, in a copy, so that the student's folder stays clean.

# Where ./dev build --robot puts headers, library and compiler facts.
find_robot_sdk() {
  robot_sdk=${DARWINOP_ROBOT_SDK:-$(readlink -f "$installer/../build/robot/sdk" || true)}
  [ -f "$robot_sdk/share/darwinop/robot-toolchain.mk" ] ||
    die "the robot's library is not built yet${robot_sdk:+ (no $robot_sdk)}. Build it, once: ./dev build --robot"
  command -v make >/dev/null || die "make is missing on this PC. Install it: sudo apt-get install make"
  case $robot_sdk in
    *[[:space:]]*) die "make cannot work with blanks in a folder's name: move $robot_sdk, or its repository" ;;
  esac
}

# Name and folder of a controller. The name is the folder's, as upstream has it.
name_controller() { # DIR -> controller_folder controller_name
  [ -d "$1" ] || die "there is no folder $1: give the folder with the controller's sources"
  controller_folder=$(cd "$1" && pwd) || die "cannot enter $1"
  controller_name=${controller_folder##*/}
  case $controller_name in
    '') die "the controller's folder cannot be /" ;;
    .* | -*) die "a controller cannot be called $controller_name: the folder's name may not begin with . or -" ;;
    *[[:cntrl:]\\]*) die "a controller cannot be called '$controller_name': rename the folder" ;;
  esac
}

# A folder of its own for each controller: the copy, its objects, the program. Kept, so that the next time is quick.
open_build_cache() { # -> controller_cache controller_copy
  cache_root=${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt/controllers
  case $cache_root in
    *[[:space:]]*) die "make cannot work with blanks in a folder's name: set XDG_CACHE_HOME to a place other than $cache_root" ;;
  esac
  identity=$(printf '%s' "$controller_folder" | cksum) || die "cannot run cksum"
  case $controller_name in
    *[!A-Za-z0-9_.+-]*) safe_name=controller ;;  # make cannot work with blanks, $ or # in names
    *) safe_name=$controller_name ;;
  esac
  controller_cache=$cache_root/$safe_name-${identity%% *}
  controller_copy=$controller_cache/$safe_name
  mkdir -p "$controller_copy" || die "cannot write to $cache_root: set XDG_CACHE_HOME to a place that can be written to"
  # Two terminals that send the same controller build one after the other.
  exec 8>"$controller_cache/lock"
  ! command -v flock >/dev/null || flock 8
}

is_program() { [ -f "$1" ] && [ -x "$1" ] && [ "$(od -An -tx1 -N4 "$1" | tr -d ' \n')" = 7f454c46 ]; }

# The next one may build; what was built here is packed.
close_build_cache() { exec 8>&-; }

# Copies what changed. By content, as a file that came back from a backup may be older than what was built from it.
copy_sources() {
  made_with=$(cat "$robot_sdk/share/darwinop/robot-toolchain.mk" "$robot_sdk/share/darwinop/Makefile.include" | cksum)
  list_build_files "$controller_folder" >"$controller_cache/files.now"
  printf '%s\n' "$robot_sdk $made_with" >"$controller_cache/made-with.now"
  if ! cmp -s "$controller_cache/made-with.now" "$controller_cache/made-with" ||
      [ -n "$(LC_ALL=C comm -13 "$controller_cache/files.now" "$controller_cache/files" 2>/dev/null || echo new)" ]; then
    # Another library, or a file that is gone: what was built from it must not stay.
    rm -rf "$controller_copy"
    mkdir "$controller_copy"
  fi
  while IFS= read -r file; do
    # What the PC's own build left is no source.
    if is_program "$controller_folder/$file" || cmp -s "$controller_folder/$file" "$controller_copy/$file"; then continue; fi
    mkdir -p "$controller_copy/${file%/*}"
    cp "$controller_folder/$file" "$controller_copy/$file" || die "cannot copy $controller_folder/${file#./} to $controller_copy"
  done <"$controller_cache/files.now"
  mv "$controller_cache/files.now" "$controller_cache/files"
  mv "$controller_cache/made-with.now" "$controller_cache/made-with"
}

# The controller's own Makefile where it builds on Makefile.include, else the rules of Makefile.include alone.
choose_makefile() { # -> controller_makefile
  printf 'include %s\n' "$robot_sdk/share/darwinop/Makefile.include" >"$controller_cache/Makefile.include"
  controller_makefile=../Makefile.include
  for makefile in Makefile.darwin-op Makefile.robotis-op2; do
    [ -f "$controller_copy/$makefile" ] || continue
    if [ "$makefile" = Makefile.darwin-op ] || grep -q 'Makefile\.include' "$controller_copy/$makefile"; then
      controller_makefile=$makefile
    else
      say "$makefile links the libraries of a robot without darwinop; all *.cpp of the folder are built instead"
    fi
    return
  done
  set -- "$controller_copy"/*.cpp
  [ -f "$1" ] || die "$controller_folder holds no *.cpp and no Makefile.darwin-op: there is nothing to build"
}

run_make() {
  (
    cd "$controller_copy" || exit 1
    # What is set for programs of this PC must not reach a program of the robot.
    unset TARGET CXX_SOURCES CXXFLAGS CFLAGS CPPFLAGS LDFLAGS LFLAGS MAKEFLAGS CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH \
      LIBRARY_PATH DARWINOP_ROOT WEBOTS_DARWINOP_PROJECT_ROOT
    exec make -s --no-print-directory -j "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" -f "$controller_makefile" 8>&-
  )
}

# What a robot without any library can run: an i386 ELF program that asks for no loader.
is_static_i386() { # FILE
  # shellcheck disable=SC2046  # one number a byte
  set -- "$1" $(od -An -v -tu1 -N52 "$1")
  [ $# = 53 ] || return 1
  file=$1
  shift
  [ "$1 $2 $3 $4 $5 $6" = "127 69 76 70 1 1" ] || return 1  # ELF, 32 bit, little endian
  case "${17} ${18} ${19} ${20}" in "2 0 3 0" | "3 0 3 0") ;; *) return 1 ;; esac  # at a fixed place or at any, for the 386
  offset=$((${29} + 256 * ${30} + 65536 * ${31})) size=$((${43} + 256 * ${44})) count=$((${45} + 256 * ${46}))
  while [ $count -gt 0 ]; do
    # shellcheck disable=SC2046
    set -- $(od -An -v -tu1 -j "$offset" -N4 "$file")
    [ "$*" != "3 0 0 0" ] || return 1  # PT_INTERP names a loader
    offset=$((offset + size)) count=$((count - 1))
  done
}

# A Makefile may set TARGET: then the one program in the folder is meant.
find_program() { # -> controller_program
  controller_program=$controller_copy/$safe_name
  is_program "$controller_program" && return
  controller_program=
  for file in "$controller_copy"/*; do
    is_program "$file" || continue
    [ -z "$controller_program" ] ||
      die "$controller_makefile made two programs, ${controller_program##*/} and ${file##*/}: call one as the folder, $controller_name"
    controller_program=$file
  done
  [ -n "$controller_program" ] || die "$controller_makefile made no program in $controller_copy"
}

# Warnings are shown and are no failure; errors end it with the compiler's own lines above.
compile_controller() { # DIR
  find_robot_sdk
  name_controller "$1"
  check_controller_files "$controller_folder"
  open_build_cache
  copy_sources
  choose_makefile
  say "building $controller_name for the robot"
  run_make >&2 || die "$controller_name does not compile; the lines above name file and line. Nothing was sent"
  find_program
  is_static_i386 "$controller_program" ||
    die "${controller_program##*/} is no program that the robot can run (static, i386). Its $controller_makefile must leave CXX and the libraries to ../Makefile.include"
}
