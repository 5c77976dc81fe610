#!/usr/bin/env bash
# robot-vm.sh: a robot's computer without a robot: a row of robot-vm/machines/, whose /dev/ttyUSB0 is the virtual CM-730 of
# this machine. See docs/robot-vm.md.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
repository=$(dirname "$here")
machine=${ROBOT_VM_MACHINE:-i686}
if [[ $machine == */* ]] || [ ! -e "$here/robot-vm/machines/$machine.sh" ]; then
  echo "robot-vm: no machine '$machine'; ROBOT_VM_MACHINE is one of: $(basename -s .sh -a "$here"/robot-vm/machines/* | paste -sd' ')" >&2
  exit 2
fi
# shellcheck source=robot-vm/machines/i686.sh
. "$here/robot-vm/machines/$machine.sh"
# The state of one machine: in a folder of one's own, as process ids that are signalled stand in it.
suffix=$([ "$machine" = i686 ] || echo "-$machine")
vm=${ROBOT_VM:-${XDG_RUNTIME_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt}/darwinop-robot-vm-$(id -u)$suffix}
port=${ROBOT_VM_PORT:-2222}                                          # of 127.0.0.1; leads to the machine's sshd

# The virtual robot of the newest build for this machine.
virtual_robot() {
  local program newest=${DARWINOP_VIRTUAL_ROBOT:-}
  for program in "$repository"/build/{release,debug}/bin/darwinop-virtual-robot; do
    if [ -z "${DARWINOP_VIRTUAL_ROBOT:-}" ] && [ -x "$program" ] && [ "$program" -nt "$newest" ]; then newest=$program; fi
  done
  [ -x "$newest" ] || die "there is no darwinop-virtual-robot; run: ./dev build"
  echo "$newest"
}

say() { printf '%s\n' "robot-vm: $*" >&2; }
die() { say "$*"; exit 1; }

# alive FILE: the process whose id FILE holds still runs, and file and process are ours: its command names our folder.
alive() {
  [ -s "$1" ] && [ -O "$1" ] && [ ! -L "$1" ] && [ -O "/proc/$(cat "$1")" ] && kill -0 "$(cat "$1")" 2>/dev/null &&
    tr '\0' ' ' <"/proc/$(cat "$1")/cmdline" 2>/dev/null | grep -qF -- "$vm/"
}

# end FILE SIGNAL: signals that process and waits until it is gone.
end() {
  alive "$1" || return 0
  kill "-$2" "$(cat "$1")" 2>/dev/null || true
  for _ in $(seq 200); do alive "$1" || break; sleep 0.05; done
  alive "$1" && die "process $(cat "$1") does not end"
  rm -f "$1"
}

# --- the image, made once for each recipe --------------------------------------------------------------------------

image_folder() {
  local recipe
  recipe=$(cd "$here/robot-vm" && cat -- packages *.sh *.c "machines/$machine.sh" | sha256sum | cut -c1-12)
  echo "${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt/vm-$recipe"
}

cmd_build() {
  local image making started=$SECONDS
  image=$(image_folder)
  [ -e "$image/disk.img" ] && return
  say "making the disk image of $description, once: a minute; several where qemu-user runs its programs"
  mkdir -p "$(dirname "$image")"
  making=$(mktemp -d "$(dirname "$image")/making.XXXXXX")
  if ! "$here/robot-vm/make-image.sh" "$machine" "$making" >"$making/log" 2>&1; then
    cat "$making/log" >&2
    rm -rf "$making"
    die "the image could not be made; is the Debian archive reachable (apt-get update)?"
  fi
  # A second process at the same time finds the folder there, which serves as well.
  mv -T "$making" "$image" 2>/dev/null || rm -rf "$making"
  say "image made in $((SECONDS - started)) s: $image"
}

# --- the machine ---------------------------------------------------------------------------------------------------

running() { alive "$vm/qemu.pid"; }

start_virtual_robot() {
  local program
  if [ -n "${ROBOT_VM_SERIAL:-}" ]; then
    ln -sfn "$ROBOT_VM_SERIAL" "$vm/serial"
    return
  fi
  ln -sfn robot "$vm/serial"
  alive "$vm/robot.pid" && return
  program=$(virtual_robot)
  "$program" --link "$vm/robot" --body "${ROBOT_VM_BODY:-plain}" >"$vm/robot.log" 2>&1 </dev/null &
  echo $! >"$vm/robot.pid"
  for _ in $(seq 100); do [ -e "$vm/robot" ] && return; sleep 0.05; done
  die "the virtual robot did not start: $(cat "$vm/robot.log")"
}

# The disk of one machine: what differs from the image. It stays when the machine is off, until 'reset'.
boot() {
  local image=$1
  [ -e "$vm/disk.qcow2" ] || qemu-img create -q -f qcow2 -F raw -b "$image/disk.img" "$vm/disk.qcow2"
  # cache=writeback: as a disk with a write cache. What the machine has not flushed may be lost with a power cut, and
  # what it flushed is not; 'unsafe' would lose that too, 'writethrough' would lose nothing.
  # usb-serial is an FTDI chip. serial,path= hands its bytes to the pty of the virtual robot.
  "$qemu" -name robot "${hardware[@]}" -accel tcg,thread=multi -nodefaults -display none \
    -kernel "$image/vmlinuz" -initrd "$image/initrd.img" \
    -append "root=/dev/vda ro console=$console net.ifnames=0 quiet systemd.show_status=1 mitigations=off audit=0 panic=5 ${ROBOT_VM_KERNEL:-}" \
    -drive "file=$vm/disk.qcow2,if=virtio,format=qcow2,cache=writeback" \
    -netdev "user,id=net,restrict=on,hostfwd=tcp:127.0.0.1:$port-:22" -device virtio-net-pci,netdev=net,romfile= \
    -device virtio-rng-pci \
    -chardev "serial,id=cm730,path=$(readlink -f "$vm/serial")" -device usb-serial,chardev=cm730,always-plugged=on \
    -serial "file:$vm/console.log" -monitor "unix:$vm/monitor,server=on,wait=off" \
    -pidfile "$vm/qemu.pid" -daemonize
}

# wait_for_ssh OFFSET: until the console says, behind OFFSET, that sshd is there. Knocking at its door instead would
# slow the machine down: it needs a second for each greeting.
wait_for_ssh() {
  local started=$SECONDS
  until tail -c "+$(($1 + 1))" "$vm/console.log" | grep -q 'Started.*Secure Shell'; do
    running || die "the machine ended: $(tail -n 5 "$vm/console.log")"
    [ $((SECONDS - started)) -lt "$boot_limit" ] || die "no ssh after $boot_limit s; see $vm/console.log"
    sleep 0.2
  done
  ssh_root -o ConnectTimeout=60 true || die "it does not let root in; see $vm/console.log"
}

# The door of those who test. The installer goes in as $user with the password, as on a robot.
ssh_root() {
  ssh -q -F none -i "$vm/key" -p "$port" -o IdentitiesOnly=yes -o BatchMode=yes -o UserKnownHostsFile="$vm/known_hosts" \
    -o StrictHostKeyChecking=yes root@127.0.0.1 "$@"
}

cmd_start() {
  local image started
  running && die "it runs already; stop it first: $0 stop"
  cmd_build
  image=$(image_folder)
  mkdir -p "$vm"
  if [ -L "$vm" ] || [ ! -O "$vm" ]; then die "$vm is a link or belongs to somebody else; name another folder with ROBOT_VM"; fi
  chmod 700 "$vm"
  if [ -e "$vm/disk.qcow2" ] && [ "$(cat "$vm/image")" != "$image" ]; then
    die "the disk belongs to another image; for a fresh one: $0 reset"
  fi
  echo "$image" >"$vm/image"
  start_virtual_robot
  cp "$image/key" "$vm/key"
  echo "[127.0.0.1]:$port $(cut -d' ' -f1,2 "$image/host_key.pub")" >"$vm/known_hosts"
  started=$(date +%s%N)
  boot "$image"
  wait_for_ssh 0
  say "up after $((($(date +%s%N) - started) / 1000000)) ms; ssh -p $port $user@127.0.0.1, password 111111"
}

# Restarts it as the command 'reboot' does, and waits.
cmd_reboot() {
  local offset
  offset=$(stat -c %s "$vm/console.log")
  cmd_ssh systemctl reboot 2>/dev/null || true  # the connection goes down with it
  wait_for_ssh "$offset"
}

# Switches it off as one should.
cmd_stop() {
  if running; then
    ssh_root -o ConnectTimeout=10 systemctl poweroff 2>/dev/null || true
    for _ in $(seq 60); do running || break; sleep 0.5; done
    running && say "it does not switch off, so its power is cut"
  fi
  end "$vm/qemu.pid" KILL
  end "$vm/robot.pid" TERM
}

# Cuts its power. The virtual robot is another supply and stays.
cmd_kill() { end "$vm/qemu.pid" KILL; }

# Off, and a fresh disk for the next start.
cmd_reset() {
  cmd_kill
  end "$vm/robot.pid" TERM
  rm -f "$vm/disk.qcow2"
}

cmd_ssh() {
  running || die "it does not run; start it: $0 start"
  ssh_root "$@"
}

# Where the virtual robot's joints are, rad, and with ROBOT_VM_BODY=twin its trunk, m.
cmd_joints() {
  local lines
  alive "$vm/robot.pid" || die "no virtual robot runs here"
  lines=$(wc -l <"$vm/robot.log")
  kill -USR1 "$(cat "$vm/robot.pid")"
  for _ in $(seq 50); do
    [ "$(wc -l <"$vm/robot.log")" = "$lines" ] || break
    sleep 0.02
  done
  sed -n '$s/^joints: //p' "$vm/robot.log"
}

cmd_status() {
  echo "machine:       $description ($machine)"
  echo "image:         $(image_folder) $([ -e "$(image_folder)/disk.img" ] || echo '(not made yet)')"
  echo "power:         $(running && echo "runs, ssh -p $port $user@127.0.0.1" || echo off)"
  echo "virtual robot: $(alive "$vm/robot.pid" && echo "runs, $vm/robot" || echo off)"
  echo "disk:          $([ -e "$vm/disk.qcow2" ] && du -h "$vm/disk.qcow2" || echo 'as the image')"
  running
}

command=${1:-help}
[ $# = 0 ] || shift
case $command in
  build | start | reboot | stop | kill | reset | ssh | status | joints) "cmd_$command" "$@" ;;
  *)
    echo "usage: $0 build|start|reboot|stop|kill|reset|status|joints|ssh [COMMAND]   (docs/robot-vm.md)" >&2
    exit 2
    ;;
esac
