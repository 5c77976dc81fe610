# shellcheck shell=bash disable=SC2034,SC2100
# The computer of a DARwIn-OP or OP2, re-imaged with Debian 12. Sourced; the file's name is that of its bundle's architecture.
description='Debian 12 i386 on an emulated Atom N270'
debian=i386                          # Debian's name of the architecture
kernel=linux-image-686-pae           # with PAE, as the Z530 wants it
compiler=i686-linux-gnu-gcc          # for the stand-in of the demo
user=darwin
demo=yes                             # /etc/rc.local starts a demo, as ROBOTIS delivers it
ways='rc.local systemd'              # to start at boot, for tests/vm/robot_vm_test.sh
preset=robot                         # build/PRESET has bundle and SDK
qemu=qemu-system-i386
# -cpu n270: 32 bit, SSSE3, no SSE4: an instruction that a Z530 lacks ends the program. One core with two threads and
# 1 GB, as the robot's.
hardware=(-machine pc -cpu n270 -smp 'cores=1,threads=2' -m 1024 -usb)
console=ttyS0
boot_limit=240                       # s, until sshd answers on a busy PC
