# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Runs on the robot as root, sent as one command line: sh, tar, gzip and coreutils of 2009 are all there is.
# installer/pc/connection.sh puts all files of this folder together and ends them with `main FUNCTION ARGUMENTS`.

home=/opt/darwinop
etc=/etc

# main FUNCTION ARGUMENTS: stdin is the password line (when sudo did not take it), the line darwinop-stream, data.
main() {
  set -u
  umask 022
  LC_ALL=C PATH=$PATH:/usr/local/sbin:/usr/sbin:/sbin:/usr/local/bin:/usr/bin:/bin
  export LC_ALL PATH
  # A lost link must not end us between two steps: writing to nobody fails and that is all.
  trap '' HUP PIPE
  while IFS= read -r line; do
    if [ "$line" = darwinop-stream ]; then
      "$@"
      exit
    fi
  done
  die "the connection ended before the data began; nothing was changed"
}

say() { printf '%s\n' "robot: $*" >&2; }

# die [-CODE] SENTENCE
die() {
  code=1
  case $1 in -[0-9]*) code=${1#-}; shift ;; esac
  say "${error_mark:-}$*"
  exit "$code"
}

# put FILE [MODE]: stdin becomes FILE, all of it or nothing, also when the power goes.
put() {
  cat >"$1.new-$$" && chmod "${2:-644}" "$1.new-$$" && sync && mv -f "$1.new-$$" "$1"
}

# point LINK TARGET: swaps a symbolic link in one step.
point() {
  rm -f "$1.new-$$" && ln -s "$2" "$1.new-$$" && mv -T -f "$1.new-$$" "$1"
}

boot_id() { cat /proc/sys/kernel/random/boot_id 2>/dev/null || echo unknown; }

# process_age PID: start time in clock ticks, so that a number used again is another process. Field 22, and the
# name in field 2 may hold anything, ')' too.
process_age() {
  [ -r "/proc/$1/stat" ] || return 1
  sed 's/^.*) //' "/proc/$1/stat" 2>/dev/null | cut -d ' ' -f 20
}

lock_owner() { echo "$$ $(boot_id) $(process_age $$)"; }

# lock_alive "PID BOOT AGE": does the process that wrote this line still run?
lock_alive() {
  # shellcheck disable=SC2086
  set -- $1
  [ $# = 3 ] && [ "$2" = "$(boot_id)" ] && [ "$(process_age "$1")" = "$3" ]
}

# lock: one installer at a time. A line made beforehand is linked into place, so a lock is never without owner.
lock() {
  make_folder "$home" || die "cannot make $home"
  lock_owner >"$home/lock.new-$$" || die "cannot write into $home"
  if ! ln "$home/lock.new-$$" "$home/lock" 2>/dev/null; then
    found=$(cat "$home/lock" 2>/dev/null) || found=
    if lock_alive "$found"; then
      rm -f "$home/lock.new-$$"
      die -5 "another installation is running on this robot (process ${found%% *}); wait until it has ended"
    fi
    take_over "$found"
  fi
  rm -f "$home/lock.new-$$"
  trap unlock EXIT
}

# Between looking and moving another one may have taken the dead lock: then what was moved is theirs and goes back.
take_over() {
  mv -f "$home/lock" "$home/lock.dead-$$" 2>/dev/null
  if [ "$(cat "$home/lock.dead-$$" 2>/dev/null)" != "$1" ]; then ln "$home/lock.dead-$$" "$home/lock" 2>/dev/null; fi
  rm -f "$home/lock.dead-$$"
  ln "$home/lock.new-$$" "$home/lock" 2>/dev/null || {
    rm -f "$home/lock.new-$$"
    die -5 "another installation has just begun on this robot; wait until it has ended"
  }
}

# Tidied under the lock: the next one must not begin in a folder that is about to go.
unlock() {
  [ "$(cat "$home/lock" 2>/dev/null)" = "$(lock_owner)" ] || return
  tidy
  rm -f "$home/lock"
}
