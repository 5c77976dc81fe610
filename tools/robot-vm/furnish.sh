#!/bin/sh
# furnish.sh ROOT USER KEY.PUB [DEMO]: makes the fresh Debian under ROOT look like a robot's computer: its user and
# password, with DEMO also /etc/rc.local that starts it, as on a DARwIn-OP. KEY.PUB is let in as root: the door of those
# who test, not of the installer.
set -eu
root=$1 user=$2 key=$3 demo=${4:-}

echo "$user" >"$root/etc/hostname"
echo "127.0.0.1 localhost $user" >"$root/etc/hosts"
echo '/dev/vda / ext4 errors=remount-ro,noatime 0 1' >"$root/etc/fstab"
# One cable, one address: as qemu's network has it. Debian's ifupdown would wait for every device first.
cat >"$root/etc/systemd/system/network-cable.service" <<'END'
[Unit]
DefaultDependencies=no
BindsTo=sys-subsystem-net-devices-eth0.device
After=sys-subsystem-net-devices-eth0.device
Before=network.target
[Service]
Type=oneshot
RemainAfterExit=yes
ExecStart=/bin/ip address add 10.0.2.15/24 dev eth0
ExecStart=/bin/ip link set eth0 up
[Install]
WantedBy=network.target multi-user.target
END
chroot "$root" systemctl --quiet enable network-cable.service

chroot "$root" useradd -m -s /bin/bash -G adm,dialout,cdrom,plugdev,audio,video,sudo "$user"
echo "$user:111111" | chroot "$root" chpasswd
if [ -n "$demo" ]; then  # as ROBOTIS delivers it
  mkdir -p "$root/darwin/Linux/project/demo"
  cp "$demo" "$root/darwin/Linux/project/demo/demo"
  chmod 755 "$root/darwin/Linux/project/demo/demo"
  chroot "$root" chown -R "$user:$user" /darwin
  cat >"$root/etc/rc.local" <<'END'
#!/bin/sh -e
#
# rc.local
#
# This script is executed at the end of each multiuser runlevel.
# Make sure that the script will "exit 0" on success or any other
# value on error.

sleep 15
/darwin/Linux/project/demo/demo

exit 0
END
  chmod 755 "$root/etc/rc.local"
fi

mkdir -p "$root/root/.ssh"
chmod 700 "$root/root/.ssh"
cp "$key" "$root/root/.ssh/authorized_keys"
chmod 600 "$root/root/.ssh/authorized_keys"

# The camera: one TV input, which scales to any size, so that 320x240 is there.
echo vivid >"$root/etc/modules-load.d/robot.conf"
echo 'options vivid n_devs=1 node_types=0x1 input_types=0x1 num_inputs=1' >"$root/etc/modprobe.d/robot.conf"

# The start-up system: a program of 16 kB and the drivers of the disk. Debian's usual one takes 10 s of emulated time.
mkdir -p "$root/etc/tiny-initramfs"
cat >"$root/etc/tiny-initramfs/tiny-initramfs.conf" <<'END'
DEBUG=no
MICROCODE=no
AUTO_MODULES=no
INCLUDE_MODULES=virtio_pci,virtio_blk,crc32c_generic,ext4
END
kernel=$(basename "$root"/lib/modules/*)
chroot "$root" mktirfs -o "/boot/initrd.img-$kernel" "$kernel"

# Nothing that would change the disk by itself, or start late. The journal stays in memory, as this folder is not there.
rmdir "$root/var/log/journal"
for unit in dpkg-db-backup.timer e2scrub_all.timer e2scrub_reap.service fstrim.timer systemd-pstore.service \
  systemd-update-utmp.service getty.target; do
  ln -sf /dev/null "$root/etc/systemd/system/$unit"
done
