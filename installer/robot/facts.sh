# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# What this robot is and what speaks against installing on it. Looks only; nothing here changes a file of the robot.

# Set from NAME=VALUE words by `settings`; sizes in kB (1024 bytes).
version=- manifest=- archive_kb=0 unpacked_kb=0 archive_bytes=0 sha256=- cksum=-
force=0 without_robot=0 port='' autostart='' dry_run=0

settings() {
  for word in "$@"; do
    value=${word#*=}
    case $word in
      version=*) version=$value ;;
      manifest=*) manifest=$value ;;
      archive_kb=*) archive_kb=$value ;;
      archive_bytes=*) archive_bytes=$value ;;
      unpacked_kb=*) unpacked_kb=$value ;;
      sha256=*) sha256=$value ;;
      cksum=*) cksum=$value ;;
      force=*) force=$value ;;
      without_robot=*) without_robot=$value ;;
      port=*) port=$value ;;
      autostart=*) autostart=$value ;;
      dry_run=*) dry_run=$value ;;
      *) die "the installer's two halves do not fit: unknown setting $word" ;;
    esac
  done
}

# compare A B: prints older, same or newer, by the dotted numbers at the front: 0.10.0 is newer than 0.9.1.
compare() {
  a=${1%%[!0-9.]*} b=${2%%[!0-9.]*}
  while [ -n "$a$b" ]; do
    x=${a%%.*} y=${b%%.*}
    if [ "${x:-0}" -lt "${y:-0}" ]; then echo older && return; fi
    if [ "${x:-0}" -gt "${y:-0}" ]; then echo newer && return; fi
    case $a in *.*) a=${a#*.} ;; *) a= ;; esac
    case $b in *.*) b=${b#*.} ;; *) b= ;; esac
  done
  echo same
}

# The serial port: the robot's own setting before what this call says, as an existing robot.ini is kept.
robot_port() {
  found=
  if [ -f "$home/robot.ini" ]; then
    found=$(robot_setting port)
  elif [ -n "$port" ]; then
    found=$port
  fi
  echo "${found:-/dev/ttyUSB0}"
}

# The folder above that exists already.
existing() {
  folder=$1
  while [ ! -d "$folder" ]; do folder=$(dirname "$folder"); done
  echo "$folder"
}

free_kb() { df -P -k "$(existing "$home")" | awk 'NR == 2 { print $4 }'; }

problem() {
  problems=$((problems + 1))
  say "${error_mark:-}$*"
}

# find_problems: says each, sets $problems.
find_problems() {
  problems=0
  check_programs
  check_machine
  check_space
  check_autostart
  check_port
  if [ "$force" = 0 ] && [ "$(compare "$version" "$(version_confirmed)")" = older ] && [ "$(version_confirmed)" != - ]; then
    problem "the installed version $(version_confirmed) is newer than $version; --force installs the older one, --rollback returns to the one before"
  fi
}

check_port() {
  other="--port names another device"
  if [ -f "$home/robot.ini" ]; then
    other="another one has to be named in $home/robot.ini on the robot"
    case $port in
      '' | "$(robot_port)") ;;
      *) problem "$home/robot.ini names the port $(robot_port) and is kept; --port $port is for a new file. Change 'port' in that file, or leave --port out" ;;
    esac
  fi
  if [ "$without_robot" = 1 ] || [ -c "$(robot_port)" ]; then return; fi
  problem "there is no serial device $(robot_port); is the robot's power on and the CM-730 connected? $other, --without-robot installs without looking"
}

check_programs() {
  for program in awk cat chmod chown cksum cmp cp cut df dirname du grep gzip ln ls mkdir mktemp mv readlink rm rmdir sed sleep \
    sync tail tar tr uname wc; do
    command -v "$program" >/dev/null 2>&1 || problem "there is no program '$program' on the robot; install the package that has it"
  done
  # A name that nobody can have taken beforehand: everybody may write there.
  scratch=$(mktemp -d /dev/shm/darwinop-check-XXXXXX 2>/dev/null || mktemp -d) || {
    problem "cannot make a temporary folder in /dev/shm or /tmp; is there room?"
    return
  }
  ln -s one "$scratch/a" && ln -s two "$scratch/b" && mv -T -f "$scratch/a" "$scratch/b"
  [ "$(readlink "$scratch/b")" = one ] ||
    problem "the robot's 'mv' cannot replace a link (mv -T), which the switch between versions needs; install coreutils, or busybox 1.20 or later"
  rm -rf "$scratch"
}

check_machine() {
  case $(uname -m) in
    i686 | x86_64) ;;
    *) problem "this is a $(uname -m), not a PC with i686 instructions; is the address that of the robot?" ;;
  esac
  flags=$(sed -n 's/^flags[^:]*://p' /proc/cpuinfo | sed -n 1p)
  for flag in sse2 ssse3; do
    case " $flags " in
      *" $flag "*) ;;
      *) problem "the processor has no $flag; the programs are built for the Atom Z530 of the robot and would not run here" ;;
    esac
  done
  [ "$(compare "$(uname -r)" 2.6.31)" != older ] ||
    problem "the kernel is $(uname -r); 2.6.31 (Ubuntu 9.10) is the oldest that the programs run on"
}

check_space() {
  needed=$((2 * unpacked_kb + archive_kb))
  free=$(free_kb)
  [ "${free:-0}" -ge "$needed" ] ||
    problem "$(existing "$home") has ${free:-0} kB free, the installation needs $needed kB; remove something, for instance old recordings"
  for folder in "$(existing "$home")" "$etc"; do
    if [ -w "$folder" ] && ! read_only "$folder"; then continue; fi
    problem "$folder cannot be written to; is the disk mounted read-only?"
  done
}

# As the mount table says: for the [ -w ] of a dash of 2009, root may write everywhere.
read_only() {
  mounted_at=$(df -P "$1" | awk 'NR == 2 { print $6 }')
  awk -v at="$mounted_at" '$2 == at { options = "," $4 "," } END { exit (options !~ /,ro,/) }' /proc/mounts
}
