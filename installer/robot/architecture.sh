# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Which programs this computer runs. An archive and a controller are for one of i686, amd64, armhf and aarch64
# (tools/cmake/RobotBundle.cmake).

# architectures: the best first; nothing if there are none for it. The programs are static and have the libraries for sound
# beside them, so the kernel decides: a Raspberry Pi OS of 32 bits often has one of 64.
architectures() {
  case $(uname -m) in
    i?86) echo i686 ;;
    x86_64) echo amd64 i686 ;;
    aarch64) echo aarch64 ;;
    armv7* | armv8l) echo armhf ;;
  esac
}

# For the PC. Ends with a message where nothing runs.
report_architectures() {
  fitting=$(architectures)
  [ -n "$fitting" ] || die "$(no_programs)"
  echo "$fitting"
}

no_programs() {
  echo "$msg_no_programs ($(uname -m)); use one with an i686, x86-64, ARMv7 (Raspberry Pi 2 or later) or 64-bit ARM processor"
}

# Bundles did not name it when all were for i686.
installed_architecture() { cat "$home/current/ARCHITECTURE" 2>/dev/null || echo i686; }

# In: $architecture, of the archive.
check_machine() {
  fitting=$(architectures)
  case " $fitting " in
    *" $architecture "*) ;;
    '  ')
      problem "$(no_programs)"
      return
      ;;
    *)
      problem "$msg_archive_is_for $architecture, but this is a computer for ${fitting%% *} ($(uname -m)): build it with './dev build --robot=${fitting%% *}' and install that"
      return
      ;;
  esac
  case $architecture in
    i686) check_processor flags sse2 ssse3 && check_kernel 2.6.31 "Ubuntu 9.10" ;;
    armhf) check_processor Features neon && check_kernel 3.2 "Debian 7" ;;
    *) check_kernel 3.7 "Debian 8" ;;
  esac
}

# check_processor LINE WORD...: words of that line of /proc/cpuinfo.
check_processor() {
  features=$(sed -n "s/^$1[^:]*://p" /proc/cpuinfo | sed -n 1p)
  shift
  for feature in "$@"; do
    case " $features " in
      *" $feature "*) ;;
      *) problem "the processor does not support $feature, which the programs for $architecture need" ;;
    esac
  done
}

check_kernel() { # VERSION SYSTEM
  [ "$(compare "$(uname -r)" "$1")" != older ] ||
    problem "kernel $(uname -r) is too old; the programs need $1 ($2) or later"
}

# "Debian GNU/Linux 12 (bookworm), ", or nothing on systems of before 2012.
system_name() { sed -n 's/^PRETTY_NAME="\{0,1\}\([^"]*\)"\{0,1\}$/\1, /p' "$etc/os-release" 2>/dev/null; }
