#!/usr/bin/env bash
# make-image.sh MACHINE FOLDER: makes the virtual robot's disk, kernel and keys in FOLDER (empty). MACHINE: a file of
# machines/. As root or without rights.
# FOLDER gets disk.img (ext4), vmlinuz, initrd.img, key (root's ssh key) and host_key.pub (the machine's).
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=machines/i686.sh
. "$here/machines/$1.sh"
folder=$(readlink -f "$2")
mirror=$("$here/../apt-mirror.sh" bookworm)

# In memory the unpacking takes half as long: dpkg waits for the disk after every file.
if [ -z "${TMPDIR:-}" ] && [ "$(df --output=avail -m /dev/shm 2>/dev/null | tail -1)" -gt 3000 ]; then
  export TMPDIR=/dev/shm
fi
work=$(mktemp -d "${TMPDIR:-/tmp}/robot-vm-image.XXXXXX")
# Without root rights, parts of this run as another user, the root of a name space, who has to write somewhere: in a
# folder with a name that nobody else can see.
chmod 711 "$work"
shared=$(mktemp -d "$work/XXXXXXXXXX")
chmod 777 "$shared"
as_its_root=()
[ "$(id -u)" = 0 ] || as_its_root=(mmdebstrap --unshare-helper)
trap '"${as_its_root[@]}" find "$shared" -mindepth 1 -delete || true; rm -rf "$work"' EXIT

[ -z "$demo" ] || "$compiler" -O2 -static -o "$shared/demo" "$here/demo.c"
ssh-keygen -q -t ed25519 -N '' -C 'virtual robot' -f "$folder/key"
cp "$folder/key.pub" "$shared/"

# Of 4000 drivers those of the virtual hardware; without the others the machine starts in half the time.
drivers=(crypto lib fs/ext4 fs/jbd2 fs/mbcache fs/autofs fs/configfs net/core drivers/virtio drivers/block/virtio
  drivers/net/virtio drivers/net/net_failover drivers/char/hw_random drivers/usb/common drivers/usb/core
  drivers/usb/host drivers/usb/serial drivers/media/mc drivers/media/rc drivers/media/cec drivers/media/common
  drivers/media/v4l2-core drivers/media/test-drivers/vivid)
options=()
for path in /usr/share/man /usr/share/doc /usr/share/locale /usr/share/info '/lib/modules/*/kernel'; do
  options+=(--dpkgopt="path-exclude=$path/*")
done
for path in "${drivers[@]}"; do options+=(--dpkgopt="path-include=/lib/modules/*/kernel/$path*"); done

# What this processor cannot run, qemu-user can.
mode=(mmdebstrap --mode=auto)
if ! arch-test "$debian" >/dev/null; then
  mode=("$here/../test/emulated.sh" --all-users "$1" mmdebstrap --mode=root)
  chmod 777 "$work"  # without root rights, its root is another user
fi
packages=$kernel,$(sed -E '/^#/d; s/ .*//' "$here/packages" | paste -sd,)
"${mode[@]}" --quiet --variant=essential --architectures="$debian" --format=tar --include="$packages" \
  --aptopt='APT::Install-Recommends "false"' "${options[@]}" \
  --customize-hook="sh '$here/furnish.sh' \"\$1\" $user '$shared/key.pub' ${demo:+'$shared/demo'}" \
  bookworm "$work/root.tar" "deb $mirror bookworm main"

"${as_its_root[@]}" sh "$here/make-disk.sh" "$work/root.tar" "$shared"
for file in disk.img vmlinuz initrd.img host_key.pub; do cp --sparse=always "$shared/$file" "$folder/"; done
