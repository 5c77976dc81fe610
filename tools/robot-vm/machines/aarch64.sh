# shellcheck shell=bash disable=SC2034,SC2100
# A 64-bit ARM board, such as a Raspberry Pi 3, with Debian 12. Sourced; the file's name is that of its bundle's architecture.
description='Debian 12 arm64 on an emulated Cortex-A53'
debian=arm64                         # Debian's name of the architecture
kernel=linux-image-arm64
compiler=                            # no demo
user=pi
demo=                                # such a board comes without one, and without /etc/rc.local
ways='systemd'                       # to start at boot, for tests/vm/robot_vm_test.sh
preset=robot-aarch64                 # build/PRESET has bundle and SDK
qemu=qemu-system-aarch64
# cortex-a53: ARMv8.0, the least that aarch64 programs may need. USB is xHCI, as on a Raspberry Pi 4.
hardware=(-machine virt -cpu cortex-a53 -smp 2 -m 1024 -device qemu-xhci)
console=ttyAMA0
boot_limit=600                       # s, until sshd answers on a busy PC
