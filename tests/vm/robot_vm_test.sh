#!/usr/bin/env bash
# The whole life of an installation on the virtual robot's computer (docs/robot-vm.md): install over ssh with a
# password, default controller, reboot, upgrades with power cuts, a walk of the twin, uninstall. Needs: ./dev build
# --robot, and the virtual robot of a build for this PC (DARWINOP_VIRTUAL_ROBOT, default: that of ./dev build).
#
#   robot_vm_test.sh [rc.local] [systemd]     ways to start at boot; default: all that the machine has
#
# ROBOT_VM_MACHINE is the machine (tools/robot-vm/machines), i686 by default, whose bundle ./dev build --robot=... has made.
# Eight minutes on two cores for i686; the first time, half a minute for the disk image, several for ARM.
set -euo pipefail
started=$SECONDS
repository=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
# In memory where there is room: the machine's disk is flushed often.
scratch=$(mktemp -d "$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)/robot-vm-test.XXXXXX")
. "$(dirname "${BASH_SOURCE[0]}")/machine.sh"
# shellcheck source=../../installer/robot/messages.sh
. "$repository/installer/robot/messages.sh"
# shellcheck source=../../installer/pc/messages.sh
. "$repository/installer/pc/messages.sh"
export ROBOT_VM_PORT=${ROBOT_VM_PORT:-$((20000 + $$ % 10000))}
read -ra ways <<<"${*:-$ways}"

clean_up() {
  local status=$?
  vm reset || true
  wait || true
  if [ $status = 0 ]; then echo "robot_vm_test: passed"; else echo "robot_vm_test: failed, status $status"; fi
  rm -rf "$scratch"
}
trap clean_up EXIT
trap 'exit 130' INT TERM

# The bundle once more under a higher version: the same programs, another VERSION, another MANIFEST.
make_newer_bundle() {
  mkdir "$scratch/newer"
  tar -xzf "$bundle" -C "$scratch/newer"
  (
    cd "$scratch/newer"
    echo "$newer" >VERSION
    rm MANIFEST
    find . -type f | sed 's,^\./,,' | LC_ALL=C sort | xargs cksum >"$scratch/MANIFEST"
    mv "$scratch/MANIFEST" .
    tar -czf "$scratch/newer.tar.gz" --format=ustar -- *
  )
}

# boot_again WHERE VERSIONS: one of these versions runs then, and the joints move.
boot_again() {
  vm start 2>&1 | sed 's/^/        /'
  expect_motion "after the power cut $1"
  expect_version "$2" "after the power cut $1"
}

demo_runs() { guest 'cat /darwin/demo-has-run 2>/dev/null | wc -l'; }

# vivid, the kernel's own test camera, shows colour bars without orange: the red one passes for a ball.
sees() {
  local of_red
  of_red=$(mktemp -d)
  cp -r "$repository/controllers/04_visual_tracking" "$of_red"
  sed -i 's/28, 20, 50, 45, 0, 30/355, 15, 60, 15, 0, 30/' "$of_red/04_visual_tracking/04_visual_tracking.cpp"
  for_controller=(-- --seconds 4)
  install --controller "$of_red/04_visual_tracking" --run || fail "04_visual_tracking did not run"
  for_controller=()
  rm -r "$of_red"
  said "I see the ball"  # no message: the example's output
  say "04_visual_tracking sees red in the pictures of the kernel's test camera"
}

install_first() {
  install --bundle "$bundle" --autostart "$1" || fail "the first installation"
  said "version $version $msg_confirmed"
  say "version $version is installed, autostart by $1, over ssh with a password"
  [ "$1" != "${ways[0]}" ] || sees
  install --controller "$repository/controllers/01_hello_head" --make-default || fail "the default controller was not taken"
  say "01_hello_head is cross-compiled, sent, and the default controller"
}

reboot_without_demo() {
  local before
  before=$(demo_runs)
  vm reboot
  expect_motion "after a reboot"
  [ -n "$demo" ] || return 0
  guest 'while [ -e /run/systemd/system ] && systemctl list-jobs | grep -q rc-local; do sleep 1; done'
  [ "$(demo_runs)" = "$before" ] || fail "the ROBOTIS demo was started, though it is disabled"
  say "/etc/rc.local ran to its end without the ROBOTIS demo"
}

newer=0.99.0+test
swapped="[ \"\$(readlink $home/current)\" = versions/$newer ]"
upgrade_with_power_cuts() {
  # While the archive comes in: nothing of the old version is touched.
  power_cut "in the transfer" "[ \"\$(cat $home/versions/.staging-*/archive.tar.gz 2>/dev/null | wc -c)\" -gt 1000000 ]" \
    --bundle "$scratch/newer.tar.gz"
  boot_again "in the transfer" "$version"
  # The new version is in place, and has not shown yet that it can run here.
  power_cut "in the self-test" "[ -e $home/pending ] && $swapped" --bundle "$scratch/newer.tar.gz"
  boot_again "in the self-test" "$version"
  power_cut "behind the confirmation" "[ ! -e $home/pending ] && $swapped" --bundle "$scratch/newer.tar.gz"
  boot_again "behind the confirmation" "$version $newer"
  install --bundle "$scratch/newer.tar.gz" || fail "the installation after the power cuts"
  expect_motion "the same command again"
  expect_version "$newer" "the same command again"
}

# With physics behind the virtual board: the example walks on the machine, and the trunk of the twin on this side of the
# cable goes forwards: in 8 s by 1.07 to 1.23 m on four machines, and by 0.23 m if it walks in place.
walks() {
  local forwards
  vm stop
  ROBOT_VM_BODY=twin vm start 2>&1 | sed 's/^/        /'
  expect_motion "with the twin behind the board"
  for_controller=(-- --seconds 8)
  install --controller "$repository/controllers/05_walk" --run || fail "05_walk did not walk"
  for_controller=()
  said "It walked"  # no message: the example's output
  forwards=$(joint trunk_x)
  awk -v x="$forwards" 'BEGIN { exit !(x > 0.5) }' || fail "05_walk took the twin forwards by $forwards m only"
  say "05_walk took the twin forwards by $forwards m; $(grep 'It walked' "$scratch/install.log")"
}

uninstall() {
  install --uninstall || fail "uninstall"
  listing >"$scratch/after"
  diff "$scratch/before" "$scratch/after" || fail "the disk is not as before the installation"
  say "uninstalled; all $(wc -l <"$scratch/after") lines about the disk are as before"
}

bundle=$(ls "$repository/build/$preset"/darwinop-*-"${ROBOT_VM_MACHINE:-i686}".tar.gz)
version=$(tar -xzOf "$bundle" VERSION)
make_newer_bundle

vm start 2>&1 | sed 's/^/        /'
guest 'cat /proc/version; grep -m 1 "model name" /proc/cpuinfo; ls -l /dev/ttyUSB0 /dev/video0' | sed 's/^/        /'
if [ -n "$demo" ]; then
  until [ "$(demo_runs)" -gt 0 ]; do sleep 1; done
  say "as delivered, /etc/rc.local has started the ROBOTIS demo"
fi
say "the machine is up"
listing >"$scratch/before"
moves 4 && fail "the head moves, though nothing is installed"

for way in "${ways[@]}"; do
  install_first "$way"
  expect_motion "$way"
  reboot_without_demo
  guest "$home/current/bin/darwinop-runtime --status" | sed 's/^/        /'
  if [ "$way" = "${ways[0]}" ]; then
    upgrade_with_power_cuts
    walks
  fi
  uninstall
done
