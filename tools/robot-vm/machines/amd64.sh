# shellcheck shell=bash disable=SC2034,SC2100
# A PC board with an Intel or AMD processor of 64 bits and Debian 12. Sourced; the file's name is that of its bundle's architecture.
description='Debian 12 amd64 on an emulated x86-64 board'
debian=amd64                         # Debian's name of the architecture
kernel=linux-image-amd64
compiler=                            # no demo
user=robotis
demo=                                # such a board comes without one, and without /etc/rc.local
ways='systemd'                       # to start at boot, for tests/vm/robot_vm_test.sh
preset=robot-amd64                   # build/PRESET has bundle and SDK
qemu=qemu-system-x86_64
# qemu64 without SSE3 and CX16: the least that x86-64 programs may need. USB is xHCI, as on such boards.
hardware=(-machine q35 -cpu 'qemu64,-pni,-cx16,-svm' -smp 2 -m 1024 -device qemu-xhci)
console=ttyS0
boot_limit=240                       # s, until sshd answers on a busy PC
