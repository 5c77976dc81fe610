# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Runs on the robot as root. Requires only sh, tar, gzip and coreutils of 2009.
# installer/pc/connection.sh concatenates the files of this folder and appends `main FUNCTION ARGUMENTS`.

home=/opt/darwinop
etc=/etc

# main FUNCTION ARGUMENTS <DATA
main() {
  set -u
  umask 022
  LC_ALL=C PATH=$PATH:/usr/local/sbin:/usr/sbin:/sbin:/usr/local/bin:/usr/bin:/bin
  export LC_ALL PATH
  # A lost connection must not end this program between two steps: ignore SIGPIPE, so that writes only fail.
  trap '' HUP PIPE
  "$@"
}

say() { printf '%s\n' "robot: $*" >&2; }

# die [-CODE] MESSAGE
die() {
  code=1
  case $1 in -[0-9]*) code=${1#-}; shift ;; esac
  say "${error_mark:-}$*"
  exit "$code"
}

# put FILE [MODE]: writes stdin to FILE atomically, also with respect to power failures.
put() {
  cat >"$1.new-$$" && chmod "${2:-644}" "$1.new-$$" && sync && mv -f "$1.new-$$" "$1"
}

# point LINK TARGET: replaces a symbolic link atomically.
point() {
  rm -f "$1.new-$$" && ln -s "$2" "$1.new-$$" && mv -T -f "$1.new-$$" "$1"
}

boot_id() { cat /proc/sys/kernel/random/boot_id 2>/dev/null || echo unknown; }

# process_age PID: start time in clock ticks, to detect pid reuse. Field 22; the name in field 2 may contain ')'.
process_age() {
  [ -r "/proc/$1/stat" ] || return 1
  sed 's/^.*) //' "/proc/$1/stat" 2>/dev/null | cut -d ' ' -f 20
}

lock_owner() { echo "$$ $(boot_id) $(process_age $$)"; }

# lock_alive "PID BOOT AGE": true if the process that wrote this line still runs.
lock_alive() {
  # shellcheck disable=SC2086
  set -- $1
  [ $# = 3 ] && [ "$2" = "$(boot_id)" ] && [ "$(process_age "$1")" = "$3" ]
}

# lock: one installer at a time. The complete file is linked into place, so a lock always has an owner.
lock() {
  make_folder "$home" || die "cannot create $home"
  lock_owner >"$home/lock.new-$$" || die "cannot write to $home"
  if ! ln "$home/lock.new-$$" "$home/lock" 2>/dev/null; then
    found=$(cat "$home/lock" 2>/dev/null) || found=
    if lock_alive "$found"; then
      rm -f "$home/lock.new-$$"
      die -5 "$msg_other_install (process ${found%% *}); wait until it has ended"
    fi
    take_over "$found"
  fi
  rm -f "$home/lock.new-$$"
  trap unlock EXIT
}

# Another process may have replaced the dead lock before the move; then its lock is moved back.
take_over() {
  mv -f "$home/lock" "$home/lock.dead-$$" 2>/dev/null
  if [ "$(cat "$home/lock.dead-$$" 2>/dev/null)" != "$1" ]; then ln "$home/lock.dead-$$" "$home/lock" 2>/dev/null; fi
  rm -f "$home/lock.dead-$$"
  ln "$home/lock.new-$$" "$home/lock" 2>/dev/null || {
    rm -f "$home/lock.new-$$"
    die -5 "another installation has just started on this robot; wait until it has ended"
  }
}

# Cleaned up under the lock: the next installation must not start in a folder that will be removed.
unlock() {
  [ "$(cat "$home/lock" 2>/dev/null)" = "$(lock_owner)" ] || return
  tidy
  rm -f "$home/lock"
}
