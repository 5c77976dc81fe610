# shellcheck shell=sh
# Cross-compiles a controller on this PC, in a copy, so that the source folder stays clean.

# Folder with headers, library and compiler options from ./dev build --robot.
find_robot_sdk() {
  robot_sdk=${DARWINOP_ROBOT_SDK:-}
  [ -n "$robot_sdk" ] || choose_robot_sdk
  { [ -f "$robot_sdk/share/darwinop/robot-toolchain.mk" ] && [ -f "$robot_sdk/share/darwinop/old-make" ]; } ||
    die "the robot's library is not built yet, or by an older version${robot_sdk:+ (no $robot_sdk)}; build it once: ./dev build --robot"
  command -v make >/dev/null || die "make not found; install it: sudo apt-get install make"
  case $robot_sdk in
    *[[:space:]]*) die "make does not support blanks in folder names: move $robot_sdk or its repository" ;;
  esac
}

# The one that was built; of several, the one for the version that is installed on the robot.
choose_robot_sdk() { # -> robot_sdk
  robot_sdk=$(readlink -f "$installer/../build/robot/sdk" || true) sdk_count=0
  for folder in "$installer"/../build/robot*/sdk; do
    [ -f "$folder/share/darwinop/robot-toolchain.mk" ] || continue
    sdk_count=$((sdk_count + 1)) found=$(readlink -f "$folder")
  done
  [ $sdk_count != 1 ] || robot_sdk=$found
  if [ $sdk_count -lt 2 ] || [ "${dry_run:-0}" = 1 ]; then return; fi
  connect
  ask_installed_architecture
  folder=robot-$installed
  [ "$installed" != i686 ] || folder=robot
  robot_sdk=$(readlink -f "$installer/../build/$folder/sdk" || true)
  [ -d "$robot_sdk" ] || die "$target $msg_not_built $installed: build them with './dev build --robot=$installed' and run this again"
}

# i686, amd64, armhf or aarch64.
sdk_architecture() {
  named=$(sed -n 's/^ROBOT_ARCHITECTURE := //p' "$robot_sdk/share/darwinop/robot-toolchain.mk")
  echo "${named:-i686}"
}

# A script, or a folder with scripts and nothing to compile.
refuse_python() { # DIR
  case $1 in
    *.py) script=$1 ;;
    *)
      set -- "$1" "$1"/*.cpp "$1"/Makefile.darwin-op "$1"/*.py
      for file; do [ -f "$file" ] && break; done
      [ -f "$file" ] || return 0
      script=$file
      case $script in *.py) ;; *) return 0 ;; esac
      ;;
  esac
  die "$script cannot be sent, because the robot's programs include no Python: run it on this PC with darwinop run --robot tcp://$target $script"
}

# Name and folder of a controller. As in upstream, the name is the folder's.
name_controller() { # DIR -> controller_folder controller_name
  [ -d "$1" ] || die "folder $1 $msg_no_folder with the controller's sources"
  controller_folder=$(cd "$1" && pwd) || die "cannot enter $1"
  controller_name=${controller_folder##*/}
  case $controller_name in
    '') die "the controller's folder cannot be /" ;;
    .* | -*) die "invalid controller name $controller_name: the folder's name must not start with . or -" ;;
    *[[:cntrl:]\\]*) die "invalid controller name '$controller_name': rename the folder" ;;
  esac
}

# One cache folder per controller: copy, objects, program. Kept for incremental builds.
open_build_cache() { # -> controller_cache controller_copy
  cache_root=${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt/controllers
  case $cache_root in
    *[[:space:]]*) die "make does not support blanks in folder names: set XDG_CACHE_HOME to another folder than $cache_root" ;;
  esac
  identity=$(printf '%s' "$controller_folder" | cksum) || die "cannot run cksum"
  case $controller_name in
    *[!A-Za-z0-9_.+-]*) safe_name=controller ;;  # make does not support blanks, $ or # in names
    *) safe_name=$controller_name ;;
  esac
  controller_cache=$cache_root/$safe_name-${identity%% *}
  controller_copy=$controller_cache/$safe_name
  mkdir -p "$controller_copy" || die "cannot write to $cache_root: set XDG_CACHE_HOME to a writable folder"
  # Serializes builds of the same controller from two terminals.
  exec 8>"$controller_cache/lock"
  ! command -v flock >/dev/null || flock 8
}

is_program() { [ -f "$1" ] && [ -x "$1" ] && [ "$(od -An -tx1 -N4 "$1" | tr -d ' \n')" = 7f454c46 ]; }

# The program is packed; another build may start.
close_build_cache() { exec 8>&-; }

# Copies changed files. Compares contents: a restored file may be older than its object.
copy_sources() {
  made_with=$(cat "$robot_sdk/share/darwinop/robot-toolchain.mk" "$robot_sdk/share/darwinop/Makefile.include" \
    "$robot_sdk/share/darwinop/old-make" | cksum)
  list_build_files "$controller_folder" >"$controller_cache/files.now"
  printf '%s\n' "$robot_sdk $made_with" >"$controller_cache/made-with.now"
  if ! cmp -s "$controller_cache/made-with.now" "$controller_cache/made-with" ||
      [ -n "$(LC_ALL=C comm -13 "$controller_cache/files.now" "$controller_cache/files" 2>/dev/null || echo new)" ]; then
    # Other library or removed files: discard all objects.
    rm -rf "$controller_copy"
    mkdir "$controller_copy"
  fi
  while IFS= read -r file; do
    # Build outputs of the PC are not sources.
    if is_program "$controller_folder/$file" || cmp -s "$controller_folder/$file" "$controller_copy/$file"; then continue; fi
    mkdir -p "$controller_copy/${file%/*}"
    cp "$controller_folder/$file" "$controller_copy/$file" || die "cannot copy $controller_folder/${file#./} to $controller_copy"
  done <"$controller_cache/files.now"
  mv "$controller_cache/files.now" "$controller_cache/files"
  mv "$controller_cache/made-with.now" "$controller_cache/made-with"
}

# The controller's Makefile if it is for Makefile.include or from before it, else only the rules of Makefile.include.
choose_makefile() { # -> controller_makefile makefile_is_full
  makefile_is_full=0
  printf 'include %s\n' "$robot_sdk/share/darwinop/Makefile.include" >"$controller_cache/Makefile.include"
  controller_makefile=../Makefile.include
  for makefile in Makefile.darwin-op Makefile.robotis-op2; do
    [ -f "$controller_copy/$makefile" ] || continue
    if grep -q '^ *include  *\.\./Makefile\.include' "$controller_copy/$makefile"; then
      controller_makefile=$makefile
    elif [ "$makefile" = Makefile.darwin-op ]; then
      controller_makefile=$makefile makefile_is_full=1
    else
      say "$makefile is for the libraries of a robot without darwinop; building all *.cpp $msg_instead"
    fi
    return
  done
  set -- "$controller_copy"/*.cpp
  [ -f "$1" ] || die "$controller_folder contains no *.cpp and no Makefile.darwin-op: $msg_nothing_to_build"
}

run_make() {
  (
    cd "$controller_copy" || exit 1
    # Compiler settings of this PC must not affect the cross-compilation.
    unset TARGET CXX_SOURCES CXXFLAGS CFLAGS CPPFLAGS LDFLAGS LFLAGS MAKEFLAGS CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH \
      LIBRARY_PATH DARWINOP_ROOT WEBOTS_DARWINOP_PROJECT_ROOT
    # From before September 2013: its paths are replaced.
    maker="make -f" jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
    [ "$makefile_is_full" = 0 ] || maker="$robot_sdk/share/darwinop/old-make"
    # shellcheck disable=SC2086  # words; the SDK's path has no blanks
    exec $maker "$controller_makefile" -s --no-print-directory -j "$jobs" 8>&-
  )
}

# A program for a robot without libraries: static ELF for its architecture.
is_static_program() { # FILE ARCHITECTURE
  case $2 in
    i686) bits=1 machine="3 0" ;;
    amd64) bits=2 machine="62 0" ;;
    armhf) bits=1 machine="40 0" ;;
    aarch64) bits=2 machine="183 0" ;;
  esac
  # shellcheck disable=SC2046  # one number per byte
  set -- "$1" $(od -An -v -tu1 -N64 "$1")
  [ $# = 65 ] || return 1
  file=$1
  shift
  [ "$1 $2 $3 $4 $5 $6" = "127 69 76 70 $bits 1" ] || return 1  # ELF, 32 or 64 bit, little endian
  case "${17} ${18} ${19} ${20}" in "2 0 $machine" | "3 0 $machine") ;; *) return 1 ;; esac  # ET_EXEC or ET_DYN
  if [ "$bits" = 1 ]; then
    offset=$((${29} + 256 * ${30} + 65536 * ${31})) size=$((${43} + 256 * ${44})) count=$((${45} + 256 * ${46}))
  else
    offset=$((${33} + 256 * ${34} + 65536 * ${35})) size=$((${55} + 256 * ${56})) count=$((${57} + 256 * ${58}))
  fi
  while [ $count -gt 0 ]; do
    # shellcheck disable=SC2046
    set -- $(od -An -v -tu1 -j "$offset" -N4 "$file")
    [ "$*" != "3 0 0 0" ] || return 1  # PT_INTERP names a loader
    offset=$((offset + size)) count=$((count - 1))
  done
}

# A Makefile may set TARGET; then the folder must contain exactly one program.
find_program() { # -> controller_program
  controller_program=$controller_copy/$safe_name
  is_program "$controller_program" && return
  controller_program=
  for file in "$controller_copy"/*; do
    is_program "$file" || continue
    [ -z "$controller_program" ] ||
      die "$controller_makefile built two programs, ${controller_program##*/} and ${file##*/}: name one like the folder, $controller_name"
    controller_program=$file
  done
  [ -n "$controller_program" ] || die "$controller_makefile built no program in $controller_copy"
}

# Warnings are printed; errors end the command after the compiler's output.
compile_controller() { # DIR
  refuse_python "$1"
  name_controller "$1"
  check_controller_files "$controller_folder"
  find_robot_sdk  # may connect to the robot
  open_build_cache
  copy_sources
  choose_makefile
  say "building $controller_name for the robot ($(sdk_architecture))"
  run_make >&2 || die "$controller_name does not compile, see the lines above. Nothing was sent"
  find_program
  is_static_program "$controller_program" "$(sdk_architecture)" ||
    die "${controller_program##*/} $msg_not_static. Its $controller_makefile must call the compiler as g++ or c++"
}
