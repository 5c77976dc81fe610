#!/bin/sh
# apt-mirror.sh [RELEASE]: prints the address of the Debian archive that apt on this machine is set up with, so that
# no script here has to name a host. DEBIAN_MIRROR overrides it.
set -eu
release=${1:-bookworm}

if [ -n "${DEBIAN_MIRROR:-}" ]; then
  echo "$DEBIAN_MIRROR"
  exit
fi
# $(...) are apt's fields, not commands. Main of the release itself, not of its updates; any architecture will do.
# shellcheck disable=SC2016
mirror=$(apt-get indextargets --format '$(CODENAME) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
  sed -nE "s,^$release main ([a-z]+:/),\\1,p" | sed -n 1p)
if [ -z "$mirror" ]; then
  echo "apt-mirror.sh: apt on this machine has no 'main' of Debian $release." \
    "Set DEBIAN_MIRROR to the address of a Debian archive." >&2
  exit 1
fi
echo "$mirror"
