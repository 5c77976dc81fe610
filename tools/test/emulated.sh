#!/bin/sh
# emulated.sh [--all-users] aarch64|armhf COMMAND...: runs COMMAND where programs for that architecture start by themselves, through
# qemu-user, also those that other programs start. In a namespace of its own: nothing of this machine is changed.
# --all-users: as its root, who may have files of every user and change into a tree of that architecture, with qemu-user-static.
set -eu
static=
if [ "$1" = --all-users ]; then
  static=-static
  shift
fi
architecture=$1
shift
# Magic number and mask of an ELF file, ET_EXEC or ET_DYN, as in Debian's qemu-user-binfmt.
case $architecture in
  aarch64) qemu=qemu-aarch64 elf='\x7fELF\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00' ;;
  armhf) qemu=qemu-arm elf='\x7fELF\x01\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\x28\x00' ;;
  *) echo "emulated.sh: no emulator for $architecture" >&2 && exit 2 ;;
esac
mask='\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff'
program=$(command -v "$qemu$static") || {
  echo "emulated.sh: $qemu$static is missing; install qemu-user$static" >&2
  exit 2
}

# enter COMMAND...: as root of a namespace.
enter() {
  if [ -z "$static" ]; then exec unshare --user --map-root-user --mount "$@"; fi
  if [ "$(id -u)" != 0 ]; then exec mmdebstrap --unshare-helper "$@"; fi
  # Root may map all users itself, but only into a namespace that is there already: the sleeping process has it.
  unshare --user sleep 1000000 &
  holder=$!
  trap 'kill $holder' EXIT
  while [ "$(readlink "/proc/$holder/ns/user")" = "$(readlink /proc/self/ns/user)" ]; do sleep 0.01; done
  echo '0 0 4294967295' >"/proc/$holder/uid_map"
  echo '0 0 4294967295' >"/proc/$holder/gid_map"
  nsenter --user="/proc/$holder/ns/user" unshare --mount --pid --fork --mount-proc "$@"
}

# Linux 6.7 and later have a binfmt_misc for each user namespace.
# shellcheck disable=SC2016  # variables of the inner shell
enter sh -euc '
  line=$1
  shift
  mount -t binfmt_misc darwinop /proc/sys/fs/binfmt_misc && printf "%s" "$line" >/proc/sys/fs/binfmt_misc/register || {
    echo "emulated.sh: this kernel has no binfmt_misc of its own for a namespace (Linux 6.7 has)" >&2
    exit 2
  }
  exec "$@"' emulated ":darwinop:M::$elf:$mask:$program:FP" "$@"
