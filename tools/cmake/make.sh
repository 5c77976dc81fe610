#!/bin/sh
# make in front of the real one, in a folder that a user sets first on the PATH: `make -f Makefile.darwin-op` with a full
# Makefile, as they were before September 2013, is built by old-make. Everything else goes to the real make.
set -u

self=$(readlink -f "$0")
old_make=${self%/bin/*}/old-make

# The first make on the PATH that is neither this script nor old-make.
real_make() {
  rest=$PATH:
  while [ -n "$rest" ]; do
    folder=${rest%%:*} rest=${rest#*:}
    [ "$folder" != "${DARWINOP_OLD_MAKE:-}" ] && [ -x "$folder/make" ] && [ ! -f "$folder/../old-make" ] && { echo "$folder/make"; return; }
  done
  echo "$0: make not found; install it: sudo apt-get install make" >&2
  return 1
}

# Full, or for a Makefile.include that is missing or not ours.
needs_old_make() { # MAKEFILE
  case ${1##*/} in Makefile.darwin-op | Makefile.robotis-op2) [ -f "$1" ] || return 1 ;; *) return 1 ;; esac
  ! grep -q '^ *include  *\.\./Makefile\.include' "$1" || ! grep -qs libdarwinop "$(dirname "$1")/../Makefile.include"
}

make=$(real_make) || exit 1
[ -z "${DARWINOP_OLD_MAKE:-}" ] || exec "$make" "$@"  # inside of old-make
case " $*" in *Makefile.darwin-op* | *Makefile.robotis-op2*) ;; *) exec "$make" "$@" ;; esac

# Takes -f and -C out of the arguments.
makefile='' left=$#
while [ $left -gt 0 ]; do
  argument=$1 left=$((left - 1)) option='' value='' next=0
  shift
  case $argument in
    -f | -C) option=$argument next=1 ;;
    --file | --makefile) option=-f next=1 ;;
    --directory) option=-C next=1 ;;
    --file=* | --makefile=*) option=-f value=${argument#*=} ;;
    --directory=*) option=-C value=${argument#*=} ;;
    --*) ;;
    -f*) option=-f value=${argument#-f} ;;
    -C*) option=-C value=${argument#-C} ;;
    -?*f)  # flags and f, as -sf
      case ${argument#-} in
        *[!bBdeikLmnpqrRsStvwf]*) ;;
        *) option=-f next=1 && set -- "$@" "${argument%f}" ;;
      esac
      ;;
  esac
  if [ $next = 1 ] && [ $left -gt 0 ]; then
    value=$1 left=$((left - 1))
    shift
  fi
  case $option in
    -C) cd "$value" || exit 2 ;;
    -f)
      [ -z "$makefile" ] || set -- "$@" -f "$makefile"  # several: not one of a controller
      makefile=$value
      ;;
    *) set -- "$@" "$argument" ;;
  esac
done
needs_old_make "$makefile" || exec "$make" ${makefile:+-f "$makefile"} "$@"
exec "$old_make" "$makefile" "$@"
