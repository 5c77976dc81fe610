#!/bin/sh
# make-disk.sh ROOT.TAR FOLDER: puts a root file system into FOLDER/disk.img, and beside it what qemu starts it with.
set -eu
root=$2/root
mkdir "$root"
tar -C "$root" -xpf "$1" --numeric-owner --exclude='./dev/*'
mv "$root"/boot/vmlinuz-* "$2/vmlinuz"
mv "$root"/boot/initrd.img-* "$2/initrd.img"
cp "$root/etc/ssh/ssh_host_ed25519_key.pub" "$2/host_key.pub"
# ext4 with a journal, as a robot has it after a new installation: what a power cut leaves behind is part of the test.
# -E: tables are written now, not in the background of the first boots.
mke2fs -q -t ext4 -L robot -E lazy_itable_init=0,lazy_journal_init=0 -J size=16 -d "$root" "$2/disk.img" 1200M >/dev/null
rm -rf "$root"
# In a name space, who asked for these is another user.
chmod a+r "$2/vmlinuz" "$2/initrd.img"
