#!/bin/sh
# make-sysroot.sh [ARCHITECTURE]: prints the folder with the headers and static libraries that the robot's programs are
# built with; makes it when it is not there. Debian 12's packages of that architecture (default i386) are unpacked into the
# user's cache, none of their scripts runs, and the machine's own packages and architectures stay as they are.
set -eu

architecture=${1:-i386}
suite=bookworm
packages=libc6-dev,linux-libc-dev,libinih-dev,libcli11-dev,libgtest-dev,libgmock-dev,librapidcheck-dev,libyuv-dev,libxcb1-dev,libjpeg62-turbo-dev,libboost-dev,nlohmann-json3-dev,libasound2-dev,libsndfile1-dev,libespeak-ng-dev

# A changed list makes a new folder, so that an old one is never half renewed.
list_hash=$(printf '%s %s' "$suite" "$packages" | cksum | cut -d' ' -f1)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt
sysroot=$cache/sysroot-$architecture-$list_hash

if [ -e "$sysroot/usr/include/stdio.h" ]; then
  printf '%s\n' "$sysroot"
  exit 0
fi

say() { printf '%s\n' "make-sysroot: $*" >&2; }

mkdir -p "$cache"
work=$(mktemp -d "$cache/making.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

say "unpacking $architecture packages of Debian 12 into $sysroot (once, some seconds)"
# Without an answer mmdebstrap takes its own default.
mirror=$("$(dirname "$0")/../tools/apt-mirror.sh" "$suite" 2>/dev/null || true)
# Mode chrootless needs no root, and nothing runs in a chroot here. A tar file first: unpacked, it belongs to the user.
mmdebstrap --quiet --mode=chrootless --variant=extract --architectures="$architecture" --include="$packages" --format=tar \
  "$suite" "$work/sysroot.tar" ${mirror:+"$mirror"} >"$work/log" 2>&1 </dev/null || {
  cat "$work/log" >&2
  say "mmdebstrap could not get the packages; check the network (apt-get update) and run the same command again"
  exit 1
}
mkdir "$work/sysroot"
# A cross compiler brings its own C++ library; that of the packages only takes space. The PC's own compiler, for amd64,
# reads its C++ headers from the sysroot.
own='./usr/include/c++/*'
[ "$architecture" != amd64 ] || own=./none
# Device nodes cannot be unpacked by users, and qemu -L would prefer them to the real ones.
tar -x -f "$work/sysroot.tar" -C "$work/sysroot" --no-same-owner --exclude='./dev/*' --exclude='./usr/share/doc/*' \
  --exclude="$own" --exclude='./usr/lib/gcc/*'
# Everything on the robot is linked statically; without these links nothing can be linked otherwise by mistake.
find "$work/sysroot" -name 'lib*.so' -delete

mv -T "$work/sysroot" "$sysroot" 2>/dev/null || [ -e "$sysroot/usr/include/stdio.h" ] || {
  say "cannot put the sysroot at $sysroot; remove what is there and run the same command again"
  exit 1
}
printf '%s\n' "$sysroot"
