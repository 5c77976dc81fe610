#!/usr/bin/env bash
# A robot to install on: a real sshd in a scratch root, with sudo, /etc/rc.local and a serial device, up in a second.
#
# A test file is a bash script of this form; every scenario gets a fresh robot and becomes one ctest test:
#
#   #!/usr/bin/env bash
#   # What these scenarios are about.
#   . "$(dirname "$(readlink -f "$0")")/robot.sh"     # enters the lab: from here on nothing is the real machine
#   scenario_a_sentence_about_behaviour() {
#     local v1; v1=$(fake_bundle 0.1.0+a)             # robot_bundle.sh
#     run_install --bundle "$v1"                      # as user darwin with password 111111; sets $status and $LAB/out
#     expect_status 0                                 # robot_expect.sh
#     expect_version 0.1.0+a
#   }
#   run_scenarios "$@"                                # FILE.sh [SCENARIO...]; FILE.sh --list; 77: one was skipped
#
# The lab is a private mount, process and network namespace, so nothing is left behind, even after kill -9: its files
# lie on a tmpfs at $LAB, its processes die with this script, its port 22 is its own. The robot's root is $ROBOT
# (robot_disk.sh): sshd runs there by chroot, and everything in it can be read and changed from outside.
#
#   users        darwin (password 111111, also for sudo), robotis (key $LAB/pc/key, sudo asks nothing), root (same key)
#   PC           home $LAB/pc/home; its known_hosts already has the robot's key (forget_host_key takes it out)
#   knobs        robot_new USERLAND (gnu, busybox) makes a fresh one; /run/… files of robot_bundle.sh control the fakes;
#                $LAB/cpuinfo, $ROBOT/run/kernel, $ROBOT/run/machine, $ROBOT/etc/rc.local, start_sshd OPTIONS
#   power        robot_boot: kills what runs, a new boot id, /etc/rc.local or the systemd unit as root; sets $booted
#   comparison   robot_disk > FILE: every path with type, mode, owner, content; robot_disk --touched: with inode and time
#   variables    DARWINOP_INSTALLER (the installer to test), DARWINOP_BIN (folder of the built commands)
#
# Needs root or password-less sudo, and the packages openssh-server, openssh-client, sudo, busybox, dash, util-linux.
set -euo pipefail

HERE=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
SOURCE=$(readlink -f "$HERE/../..")
# shellcheck source=../../installer/robot/messages.sh
. "$SOURCE/installer/robot/messages.sh"
# shellcheck source=../../installer/pc/messages.sh
. "$SOURCE/installer/pc/messages.sh"
SCRIPT=$(readlink -f "$0")

die() { printf 'installer test: %s\n' "$*" >&2; exit 1; }

# --- entering the lab ---------------------------------------------------------------------------------------------

# A folder to mount the tmpfs on: one that every Debian has, and that nothing of ours lies in.
lab_folder() {
  local folder
  for folder in /srv /media /mnt; do
    case "$SOURCE/ $SCRIPT ${DARWINOP_BIN:-} ${DARWINOP_INSTALLER:-} $PWD/" in
      *"$folder/"*) ;;
      *) if [ -d "$folder" ]; then echo "$folder"; return; fi ;;
    esac
  done
  die "no folder for the robot's files: one of /srv, /media, /mnt must exist and not hold this repository"
}

enter_lab() {
  local program lab missing='' root=() spaces=(unshare --mount --pid --net --uts --ipc --fork --kill-child=KILL --mount-proc)
  for program in /usr/sbin/sshd /usr/bin/ssh /usr/bin/sudo /usr/bin/busybox /usr/bin/dash /usr/bin/unshare /usr/bin/script; do
    [ -x "$program" ] || missing+=" $program"
  done
  [ -z "$missing" ] || die "not on this machine:$missing. Install: openssh-server openssh-client sudo busybox dash util-linux"
  if [ "$(id -u)" != 0 ]; then
    sudo -n true 2>/dev/null || die "the robot is made with mount namespaces, chroot and sshd, and that needs root: \
run this as root, or as a user whose sudo asks for no password"
    root=(sudo -n env "PATH=$PATH" "DARWINOP_BIN=${DARWINOP_BIN:-}" "DARWINOP_INSTALLER=${DARWINOP_INSTALLER:-}"
      "DARWINOP_SEED=${DARWINOP_SEED:-}" "DARWINOP_EVERY=${DARWINOP_EVERY:-}")
  fi
  "${root[@]}" "${spaces[@]}" true 2>/dev/null || die "root may not make mount, process and network namespaces here \
(CAP_SYS_ADMIN is missing): in a container, start it with --privileged"
  lab=$(lab_folder)
  exec "${root[@]}" env DARWINOP_LAB="$lab" setpriv --pdeathsig KILL "${spaces[@]}" --propagation private \
    bash "$SCRIPT" "$@"
}

# Process 1 only exists inside the lab.
if [ "$$" != 1 ] || [ -z "${DARWINOP_LAB:-}" ]; then enter_lab "$@"; fi

LAB=$DARWINOP_LAB
ROBOT=$LAB/robot
ADDRESS=127.0.0.1
export LC_ALL=C PATH=$LAB/pc/bin:/usr/sbin:/usr/bin:/sbin:/bin
umask 022

furnish_lab() {
  mount -t tmpfs -o mode=755 lab "$LAB"
  mkdir -p "$LAB"/pc/home/.ssh "$LAB"/pc/tmp "$LAB"/pc/bin "$LAB"/bundles
  chmod 700 "$LAB"/pc/home "$LAB"/pc/home/.ssh
  chmod 1777 "$LAB"/pc/tmp
  busybox ip link set lo up
  hostname darwin
  # ssh asks the user database, not $HOME, where .ssh lies.
  sed "s|^root:.*|root:x:0:0:root:$LAB/pc/home:/bin/sh|" /etc/passwd >"$LAB/pc/passwd"
  mount --bind "$LAB/pc/passwd" /etc/passwd
  export HOME=$LAB/pc/home TMPDIR=$LAB/pc/tmp
  unset SSH_AUTH_SOCK SSH_ASKPASS DISPLAY XDG_CACHE_HOME XDG_CONFIG_HOME XDG_RUNTIME_DIR
  ssh-keygen -q -t ed25519 -N '' -C student -f "$LAB/pc/key"
}

# shellcheck source=robot_disk.sh
. "$HERE/robot_disk.sh"
# shellcheck source=robot_bundle.sh
. "$HERE/robot_bundle.sh"
# shellcheck source=robot_expect.sh
. "$HERE/robot_expect.sh"

# --- the PC's side ------------------------------------------------------------------------------------------------

# run_install ARGS...: the installer as on a PC whose user has gone away: no terminal, nothing on stdin.
# It logs in with the password, as darwin; $login, $password and $installer may say otherwise.
installer=${DARWINOP_INSTALLER:-$SOURCE/installer/darwinop-install}
login=darwin
password=111111
status=
run_install() {
  status=0
  printf '%s\n' "$ install $*" >"$LAB/out"
  env DARWINOP_PASSWORD="$password" timeout -k 5 90 setsid -w "$installer" "$@" "$login@$ADDRESS" \
    </dev/null >>"$LAB/out" 2>&1 || status=$?
  { cat "$LAB/out"; echo "exit code $status"; } >>"$LAB/history"
}

# run_install_on_terminal "PATTERN=ANSWER"... -- ARGS...: with a person at a terminal, who waits for each pattern and types.
run_install_on_terminal() {
  local steps=() step tries
  while [ "$1" != -- ]; do steps+=("$1"); shift; done
  shift
  rm -f "$LAB/keyboard"
  mkfifo "$LAB/keyboard"
  exec 7<>"$LAB/keyboard"
  : >"$LAB/out"
  # exec: whatever shell script(1) takes, the installer's process group is the one that the terminal listens to.
  printf '%q ' exec env -u DARWINOP_PASSWORD timeout -k 5 60 "$installer" "$@" "$login@$ADDRESS" >"$LAB/command"
  script -qefc "$(cat "$LAB/command")" /dev/null <&7 >>"$LAB/out" 2>&1 &
  for step in "${steps[@]}"; do
    tries=0
    until grep -qE -- "${step%%=*}" "$LAB/out"; do
      [ $((tries += 1)) -lt 200 ] || { cat "$LAB/out" >>"$LAB/history"; fail "the installer did not ask: ${step%%=*}"; }
      sleep 0.05
    done
    sleep 0.1  # it switches the echo off after the question
    printf '%s\n' "${step#*=}" >&7
  done
  status=0
  wait $! || status=$?
  exec 7>&-
  { cat "$LAB/out"; echo "exit code $status"; } >>"$LAB/history"
}

# pc_program NAME: stdin is a script that the installer meets first on its PATH, on the PC.
pc_program() { cat >"$LAB/pc/bin/$1"; chmod 755 "$LAB/pc/bin/$1"; }

known_hosts() { echo "$LAB/pc/home/.ssh/known_hosts"; }
forget_host_key() { rm -f "$(known_hosts)"; }
trust_host_key() {
  local key
  for key in "$ROBOT"/etc/ssh/ssh_host_*_key.pub; do echo "$ADDRESS $(cut -d' ' -f1,2 "$key")"; done >"$(known_hosts)"
}

# --- running scenarios --------------------------------------------------------------------------------------------

list_scenarios() { sed -n 's/^scenario_\([a-zA-Z0-9_]*\)().*/\1/p' "$SCRIPT"; }

# One scenario in a shell of its own. What the installer said is shown only when something is wrong.
run_scenario() (
  set -Eeuo pipefail
  trap 'printf "installer test: %s:%s: %s\n" "${BASH_SOURCE[0]##*/}" "$LINENO" "$BASH_COMMAND" >&2' ERR
  : >"$LAB/history"
  trap 'result=$?; [ $result = 0 ] || [ $result = 77 ] || cat "$LAB/history"; exit $result' EXIT
  rm -f "$LAB"/pc/bin/*
  robot_new gnu
  "scenario_$1"
)

# skip WHY: the scenario cannot be run on to its end here, and counts as skipped.
skip() { printf 'skipped: %s\n' "$*" >&2; exit 77; }

run_scenarios() {
  local name begun verdict skipped=0 failed=0
  if [ "${1:-}" = --list ]; then list_scenarios; return; fi
  # shellcheck disable=SC2046  # one name a line
  [ $# -gt 0 ] || set -- $(list_scenarios)
  furnish_lab
  for name in "$@"; do
    declare -F "scenario_$name" >/dev/null || die "no scenario '$name' in $SCRIPT; see --list"
    begun=${EPOCHREALTIME/./}
    # Not in an if: set -e must hold inside.
    set +e
    run_scenario "$name"
    local result=$?
    set -e
    case $result in
      0) verdict=ok ;;
      77) verdict=skip skipped=1 ;;
      *) verdict=FAIL failed=1 ;;
    esac
    printf '%-4s %5d ms  %s\n' $verdict \
      $(((${EPOCHREALTIME/./} - begun) / 1000)) "$name"
    robot_off
  done
  [ -z "$(ls -A "$LAB/pc/tmp")" ] || die "left behind on the PC: $(ls "$LAB/pc/tmp")"
  [ $failed = 0 ] || exit 1
  [ $skipped = 0 ] || exit 77
}
