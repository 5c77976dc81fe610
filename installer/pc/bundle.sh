# shellcheck shell=sh disable=SC2034,SC2154  # variables are shared with the other files
# The archive that is installed: where it is, what it is, how large and with which digests.

# open_bundle: sets $bundle and its facts, or ends with a sentence.
open_bundle() {
  [ -n "$bundle" ] || find_bundle
  [ -r "$bundle" ] || die "there is no archive $bundle"
  version=$(in_bundle VERSION) || die "$bundle is not a darwinop archive: it has no file VERSION"
  case $version in
    '' | [!0-9]* | *[!A-Za-z0-9.+_~-]*) die "$bundle has no usable version: '$version'" ;;
  esac
  in_bundle MANIFEST >/dev/null || die "$bundle is not a darwinop archive: it has no file MANIFEST"
  for needed in bin/darwinop-doctor bin/darwinop-runtime bin/darwinop-supervisor share/darwinop/boot share/darwinop/robot.ini; do
    in_bundle MANIFEST | grep " $needed\$" >/dev/null || die "$bundle is not complete: it has no $needed; make it again with './dev build --robot'"
  done
  manifest=$(in_bundle MANIFEST | cksum | tr ' ' '-')
  archive_bytes=$(wc -c <"$bundle" | tr -d ' ')
  archive_kb=$(((archive_bytes + 1023) / 1024))
  unpacked_kb=$(gzip -dc "$bundle" 2>/dev/null | wc -c | awk '{ print int(($1 + 1023) / 1024) }')
  cksum=$(cksum <"$bundle" | cut -d ' ' -f 1)
  sha256=-
  if command -v sha256sum >/dev/null 2>&1; then sha256=$(sha256sum <"$bundle" | cut -d ' ' -f 1); fi
}

# The newest of the build folder beside us.
find_bundle() {
  for candidate in "$installer"/../build/robot/darwinop-*-i686.tar.gz; do
    [ -f "$candidate" ] || continue
    # shellcheck disable=SC3013  # -nt is in dash, busybox and bash
    if [ -z "$bundle" ] || [ "$candidate" -nt "$bundle" ]; then bundle=$candidate; fi
  done
  [ -n "$bundle" ] || die "there is nothing to install yet; run './dev build --robot' first, or name an archive with --bundle"
}

# in_bundle FILE: its text, packed with ./ in front or without.
in_bundle() {
  gzip -dc "$bundle" 2>/dev/null | tar -xOf - "$1" 2>/dev/null || gzip -dc "$bundle" 2>/dev/null | tar -xOf - "./$1" 2>/dev/null
}

# The facts as words for the robot's `settings`.
bundle_settings() {
  quote version="$version" manifest="$manifest" archive_bytes="$archive_bytes" archive_kb="$archive_kb" \
    unpacked_kb="$unpacked_kb" sha256="$sha256" cksum="$cksum"
}
