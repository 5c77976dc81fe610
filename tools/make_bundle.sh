#!/usr/bin/env bash
# Makes what `darwinop install` sends and what controllers are cross-compiled with, from a finished robot build:
#   bundle/                            what lies in /opt/darwinop/versions/<VERSION> on the robot
#   darwinop-<VERSION>-<ARCH>.tar.gz   the same as one archive; ARCH: i686, amd64, armhf or aarch64
#   sdk/                               headers, libdarwinop.a, Makefile.include and the facts of the cross compiler
#
#   make_bundle.sh BUILD_DIRECTORY
set -euo pipefail
tools=$(dirname "$(readlink -f "$0")")
cd "$1"

# A run that is cut off leaves the archive before it, or none: never half of one.
rm -rf bundle sdk
cmake --install . --component robot --strip --prefix bundle >bundle.log
cmake --install . --component sdk --prefix sdk >sdk.log

# Licences of what is linked in, and the list of it.
cp "$tools/../LICENSE" bundle
"$tools/make_notice.sh" . bundle

# POSIX cksum is the one checksum that every robot has.
(cd bundle && find . -type f | sed 's,^\./,,' | LC_ALL=C sort | xargs cksum) >MANIFEST
mv MANIFEST bundle

# The same sources give the same archive. The robot's tar is of 2009: plain ustar, and a date that its clock has passed.
version=$(cat bundle/VERSION) architecture=$(cat bundle/ARCHITECTURE)
archive=darwinop-$version-$architecture.tar.gz
(cd bundle && tar -c --format=ustar --sort=name --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX \
  --mtime='2009-01-01 00:00Z' -- *) | gzip -9n >"$archive.new"
rm -f darwinop-*-"$architecture".tar.gz
mv "$archive.new" "$archive"
du -sk bundle "$archive" | while read -r size what; do echo "$PWD/$what: $size kB"; done
