# shellcheck shell=bash disable=SC2034,SC2100
# A 32-bit ARM system, such as a Raspberry Pi 2, with Debian 12. Sourced; the file's name is that of its bundle's architecture.
description='Debian 12 armhf on an emulated Cortex-A7'
debian=armhf                         # Debian's name of the architecture
kernel=linux-image-armmp
compiler=                            # no demo
user=pi
demo=                                # such a board comes without one, and without /etc/rc.local
ways='systemd'                       # to start at boot, for tests/vm/robot_vm_test.sh
preset=robot-armhf                   # build/PRESET has bundle and SDK
qemu=qemu-system-arm
# cortex-a7: ARMv7 with NEON, a Raspberry Pi 2; instructions of ARMv8 end the program. highmem=off: this kernel has no LPAE,
# and would not find a PCI bus above 4 GB.
hardware=(-machine 'virt,highmem=off' -cpu cortex-a7 -smp 2 -m 1024 -device qemu-xhci)
console=ttyAMA0
boot_limit=600                       # s, until sshd answers on a busy PC
