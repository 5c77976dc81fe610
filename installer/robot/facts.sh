# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# Properties of this robot, and problems that prevent an installation. Read-only.

# Set from NAME=VALUE words by `settings`; sizes in kB (1024 bytes).
version=- architecture=i686 manifest=- archive_kb=0 unpacked_kb=0 archive_bytes=0 sha256=- cksum=-
force=0 without_robot=0 port='' autostart='' dry_run=0

settings() {
  for word in "$@"; do
    value=${word#*=}
    case $word in
      version=*) version=$value ;;
      architecture=*) architecture=$value ;;
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
      *) die "version mismatch within the installer: unknown setting $word" ;;
    esac
  done
}

# compare A B: prints older, same or newer by the leading dotted numbers: 0.10.0 is newer than 0.9.1.
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

# The serial port: robot.ini has priority over --port, since an existing robot.ini is kept.
robot_port() {
  found=
  if [ -f "$home/robot.ini" ]; then
    found=$(robot_setting port)
  elif [ -n "$port" ]; then
    found=$port
  fi
  echo "${found:-/dev/ttyUSB0}"
}

# The nearest existing parent folder.
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

# find_problems: prints each problem and counts them in $problems.
find_problems() {
  problems=0
  check_programs
  check_machine
  check_space
  check_autostart
  check_port
  if [ "$force" = 0 ] && [ "$(compare "$version" "$(version_confirmed)")" = older ] && [ "$(version_confirmed)" != - ]; then
    problem "the installed version $(version_confirmed) is newer than $version; use --force to install the older one, or --rollback to return to the previous one"
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
  problem "serial device $(robot_port) not found; check the robot's power and the CM-730's cable. $other, --without-robot skips this check"
}

check_programs() {
  for program in awk cat chmod chown cksum cmp cp cut df dirname du grep gzip ln ls mkdir mktemp mv readlink rm rmdir sed sleep \
    sync tail tar tr uname wc; do
    command -v "$program" >/dev/null 2>&1 || problem "program '$program' not found on the robot; install its package"
  done
  # An unpredictable name, since the folder is world-writable.
  scratch=$(mktemp -d /dev/shm/darwinop-check-XXXXXX 2>/dev/null || mktemp -d) || {
    problem "cannot create a temporary folder in /dev/shm or /tmp; free some space"
    return
  }
  ln -s one "$scratch/a" && ln -s two "$scratch/b" && mv -T -f "$scratch/a" "$scratch/b"
  [ "$(readlink "$scratch/b")" = one ] ||
    problem "the robot's 'mv' does not support -T, which is needed to switch versions; install coreutils, or busybox 1.20 or later"
  rm -rf "$scratch"
}

check_space() {
  needed=$((2 * unpacked_kb + archive_kb))
  # A complete version is not unpacked again.
  ! whole "$home/versions/$(folder_for "$version" "$manifest")" 2>/dev/null || needed=0
  free=$(free_kb)
  free=$((${free:-0} + $(leftover_kb)))
  [ "$free" -ge "$needed" ] ||
    problem "$(existing "$home") has $free kB free, the installation needs $needed kB; free some space, for example remove old recordings"
  for folder in "$(existing "$home")" "$etc"; do
    if [ -w "$folder" ] && ! read_only "$folder"; then continue; fi
    problem "cannot write to $folder; check that the disk is not mounted read-only"
  done
}

# From the mount table: [ -w ] in dash of 2009 is always true for root.
read_only() {
  mounted_at=$(df -P "$1" | awk 'NR == 2 { print $6 }')
  awk -v at="$mounted_at" '$2 == at { options = "," $4 "," } END { exit (options !~ /,ro,/) }' /proc/mounts
}
