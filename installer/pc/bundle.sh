# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The archive to install: path, version, size and digests.

# open_bundle: sets the properties of $bundle, or exits with an error.
open_bundle() {
  [ -r "$bundle" ] || die "cannot read archive $bundle"
  version=$(in_bundle VERSION) || die "$bundle is not a darwinop archive: file VERSION is missing"
  case $version in
    '' | [!0-9]* | *[!A-Za-z0-9.+_~-]*) die "$bundle has an invalid version: '$version'" ;;
  esac
  architecture=$(in_bundle ARCHITECTURE) || architecture=i686
  in_bundle MANIFEST >/dev/null || die "$bundle is not a darwinop archive: file MANIFEST is missing"
  for needed in bin/darwinop-doctor bin/darwinop-runtime bin/darwinop-supervisor share/darwinop/boot share/darwinop/robot.ini; do
    in_bundle MANIFEST | grep " $needed\$" >/dev/null || die "$bundle is incomplete: $needed is missing; rebuild it with './dev build --robot'"
  done
  manifest=$(in_bundle MANIFEST | cksum | tr ' ' '-')
  archive_bytes=$(wc -c <"$bundle" | tr -d ' ')
  archive_kb=$(((archive_bytes + 1023) / 1024))
  unpacked_kb=$(gzip -dc "$bundle" 2>/dev/null | wc -c | awk '{ print int(($1 + 1023) / 1024) }')
  cksum=$(cksum <"$bundle" | cut -d ' ' -f 1)
  sha256=-
  if command -v sha256sum >/dev/null 2>&1; then sha256=$(sha256sum <"$bundle" | cut -d ' ' -f 1); fi
}

# Before anything else: is there an archive at all?
expect_bundle() {
  set -- "$installer"/../build/robot*/darwinop-*.tar.gz
  [ -f "$1" ] ||
    die "no archive found; run './dev build --robot' first, or specify an archive with --bundle"
}

# The newest archive in the adjacent build folder that fits the robot best.
find_bundle() {
  ask_architectures
  for architecture in $fitting; do
    for candidate in "$installer"/../build/robot*/darwinop-*-"$architecture".tar.gz; do
      [ -f "$candidate" ] || continue
      # shellcheck disable=SC3013  # -nt is in dash, busybox and bash
      if [ -z "$bundle" ] || [ "$candidate" -nt "$bundle" ]; then bundle=$candidate; fi
    done
    [ -z "$bundle" ] || return 0
  done
  die "$target $msg_not_built ${fitting%% *}: build them with './dev build --robot=${fitting%% *}' and run this again"
}

# in_bundle FILE: content of FILE, with or without ./ in its name.
in_bundle() {
  gzip -dc "$bundle" 2>/dev/null | tar -xOf - "$1" 2>/dev/null || gzip -dc "$bundle" 2>/dev/null | tar -xOf - "./$1" 2>/dev/null
}

# The properties as words for `settings` on the robot.
bundle_settings() {
  quote version="$version" architecture="$architecture" manifest="$manifest" archive_bytes="$archive_bytes" archive_kb="$archive_kb" \
    unpacked_kb="$unpacked_kb" sha256="$sha256" cksum="$cksum"
}
