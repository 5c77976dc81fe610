#!/bin/sh
# Builds a controller with a full Makefile, as they were before September 2013: absolute paths of Webots and ROBOTIS,
# rules of its own. Compilers and make are found in a folder of replacements, which are links to this script.
#   old-make [MAKEFILE [ARGUMENT OF make]...]      MAKEFILE: Makefile.darwin-op; bin/make calls it
# Prints one line with what was replaced.
set -u

note() { printf '%s\n' "$1" >>"$DARWINOP_OLD_MAKE/replaced"; }

# Headers or libraries of upstream: missing here, or outside of the controller with upstream's files.
is_upstream_folder() { # FOLDER
  [ -d "$1" ] || return 0
  case $1 in /* | ..*) ;; *) return 1 ;; esac
  for file in webots DARwInOPGaitManager.hpp RobotisOp2GaitManager.hpp LinuxDARwIn.h CM730.h MX28.h; do
    [ ! -e "$1/$file" ] || return 0
  done
  return 1
}

is_upstream_library() { # ARGUMENT
  case ${1##*/} in
    darwin.a | wrapper.a | managers.a | keyboard.a | keyboardInterface.a) return 0 ;;
    libX11.* | libjpeg.* | -lX11 | -ljpeg | -ldarwin | -lwrapper | -lmanagers | -lController | -lCppController) return 0 ;;
    *.a | *.so | *.so.*) [ ! -e "$1" ] ;;
    *) return 1 ;;
  esac
}

# The robot's compiler in place of the one that the Makefile names.
compile() { # NAME ARGUMENT...
  name=$1 links=1 left=$(($# - 1))
  shift
  while [ $left -gt 0 ]; do
    argument=$1 left=$((left - 1))
    shift
    case $argument in
      -c | -S | -E | -M | -MM) links=0 ;;
      -o | -include | -MF | -MT | -MQ | -x | -Xlinker)
        set -- "$@" "$argument" "$1"
        shift
        left=$((left - 1))
        continue
        ;;
      -I | -L | -isystem)
        folder=$1 left=$((left - 1))
        shift
        if is_upstream_folder "$folder"; then note "$argument$folder"; else set -- "$@" "$argument" "$folder"; fi
        continue
        ;;
      -I* | -L*) ! is_upstream_folder "${argument#-[IL]}" || { note "$argument"; continue; } ;;
      -m* | -static* | -pie | -no-pie | -Werror) note "$argument"; continue ;;  # the robot's are added below
      *) ! is_upstream_library "$argument" || { note "$argument"; continue; } ;;
    esac
    set -- "$@" "$argument"
  done
  compiler='' compile_flags='' link_flags=''  # Makefile.include prints them
  # shellcheck source=/dev/null
  . "$DARWINOP_OLD_MAKE/flags"
  PATH=$DARWINOP_OLD_PATH
  # shellcheck disable=SC2086  # flags are lists of words
  [ $links = 0 ] || exec $compiler $compile_flags "$@" $link_flags
  case $name:$compiler in
    *++:*) ;;
    *:*clang++) compiler=${compiler%++} ;;
    *:*g++) compiler=${compiler%g++}gcc ;;
    *:*c++) compiler=${compiler%c++}cc ;;
  esac
  # shellcheck disable=SC2086
  exec $compiler $compile_flags "$@"
}

# Upstream's libraries are not built: their folders do not exist here.
make_below() { # ARGUMENT...
  previous=
  for argument; do
    case $previous$argument in
      -C?* | --directory=?*)
        folder=${previous:+$argument}
        [ -n "$folder" ] || folder=${argument#-C} folder=${folder#--directory=}
        [ -d "$folder" ] || { note "make -C $folder"; exit 0; }
        ;;
    esac
    previous=
    [ "$argument" != -C ] || previous=-C
  done
  exec "$DARWINOP_REAL_MAKE" "$@"
}

# Rules for upstream's files in lists of prerequisites; compilers by name, so that the replacements are found.
write_additions() {
  for pattern in '/%.a' '../%.a' '/%.so' '../%.so' '/%.so.6' '/%.h' '/%.hpp' '../%.h' '../%.hpp'; do
    printf '%s: ; @:\n' "$pattern"
  done
  # shellcheck disable=SC2016  # make reads it
  for variable in CXX CC; do
    printf '%s := $(foreach word,$(%s),$(if $(filter %%/g++ %%/gcc %%/c++ %%/cc,$(word)),$(notdir $(word)),$(word)))\n' $variable $variable
  done
  printf 'MAKE := make\n'
}

# Tools without folder, target and version: /usr/bin/g++-4.4, $(CROSS)g++. At the start of a word; no option.
tools_by_name() { # MAKEFILE
  sed -E "s|\r\$||
    s#(^|[[:space:]=;&|@])([A-Za-z0-9_./\$][A-Za-z0-9_./(){}\$-]*[/)}-])?(g\+\+|gcc|c\+\+|ar|ranlib|strip)(-[0-9.]+)?([[:space:];&|]|\$)#\1\3\5#g" "$1"
}

# One line; nothing if no compiler ran.
report() { # MAKEFILE
  [ -s "$DARWINOP_OLD_MAKE/replaced" ] || return 0
  printf '%s: replaced by headers, library and flags of %s: %s\n' "$1" "$prefix" \
    "$(awk '!seen[$0]++' "$DARWINOP_OLD_MAKE/replaced" | paste -s -d ' ' -)" >&2
}

main() {
  makefile=${1:-Makefile.darwin-op}
  [ $# = 0 ] || shift
  [ -f "$makefile" ] || { echo "$0: no $makefile in $PWD" >&2; exit 1; }
  self=$(readlink -f "$0")
  data=${self%/*} prefix=${self%/share/darwinop/*}
  DARWINOP_REAL_MAKE=$(command -v make) || { echo "$0: make not found" >&2; exit 1; }
  DARWINOP_OLD_PATH=$PATH
  DARWINOP_OLD_MAKE=$(mktemp -d) || exit 1
  trap 'rm -rf "$DARWINOP_OLD_MAKE"' EXIT
  trap 'exit 130' INT TERM HUP
  # Makefiles of that time end with an error if these are not set.
  export DARWINOP_OLD_MAKE DARWINOP_OLD_PATH DARWINOP_REAL_MAKE "WEBOTS_HOME=${WEBOTS_HOME:-/usr/local/webots}" \
    "DARWINOP_ROOT=${DARWINOP_ROOT:-/darwin}" "ROBOTISOP2_ROOT=${ROBOTISOP2_ROOT:-/robotis}"
  make -s -f "$data/Makefile.include" WEBOTS_DARWINOP_PROJECT_ROOT="$prefix" darwinop-flags >"$DARWINOP_OLD_MAKE/flags" || exit 1
  for name in g++ gcc c++ cc clang++ clang make; do ln -s "$self" "$DARWINOP_OLD_MAKE/$name"; done
  write_additions >"$DARWINOP_OLD_MAKE/additions.mk"
  # Makefile.include of upstream is ours; its other files are optional.
  tools_by_name "$makefile" | sed "s|^\\( *-\\{0,1\\}include \\).*/Makefile\\.include *\$|\\1$data/Makefile.include|
    s|^ *include  *\\([/\$]\\)|-include \\1|" >"$DARWINOP_OLD_MAKE/makefile"
  PATH=$DARWINOP_OLD_MAKE:$PATH "$DARWINOP_REAL_MAKE" -f "$DARWINOP_OLD_MAKE/makefile" -f "$DARWINOP_OLD_MAKE/additions.mk" "$@"
  status=$?
  report "$makefile"
  exit $status
}

case ${0##*/} in
  make) make_below "$@" ;;
  *++ | gcc | cc | clang) compile "${0##*/}" "$@" ;;
  *) main "$@" ;;
esac
