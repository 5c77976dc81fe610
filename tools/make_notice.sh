#!/usr/bin/env bash
# Writes what of others is in the robot's programs: NOTICE, with every licence text, and sbom.cdx.json (CycloneDX 1.5).
#
#   make_notice.sh BUILD_DIRECTORY FOLDER        BUILD_DIRECTORY: a finished robot build, with its bundle
#
# What is linked is read from the build's own commands, what is included from the compiler's dependency files: a library
# that the tables below do not know, or a package without a licence text, is an error.
set -euo pipefail
build=$1 folder=$2
case $(cat "$build/ARCHITECTURE") in  # the end of the names of the compiler's packages
  i686) cross=-i386-cross ;;
  amd64) cross= ;;
  aarch64) cross=-arm64-cross ;;
  armhf) cross=-armhf-cross ;;
esac
die() { echo "make_notice.sh: $*" >&2; exit 1; }

# Library -> Debian package that has it.
package_of_library() {
  case $1 in
    libinih.a) echo libinih-dev ;;
    libxcb.a) echo libxcb1-dev ;;
    libXau.a) echo libxau-dev ;;
    libjpeg.a) echo libjpeg62-turbo-dev ;;
    libespeak-ng.a) echo libespeak-ng-dev ;;
    libasound.so.*) echo libasound2 ;;
    libsndfile.so.*) echo libsndfile1 ;;
    libFLAC.so.*) echo libflac12 ;;
    libmp3lame.so.*) echo libmp3lame0 ;;
    libmpg123.so.*) echo libmpg123-0 ;;
    libogg.so.*) echo libogg0 ;;
    libopus.so.*) echo libopus0 ;;
    libsonic.so.*) echo libsonic0 ;;
    libvorbis.so.*) echo libvorbis0a ;;
    libvorbisenc.so.*) echo libvorbisenc2 ;;
    libc.so.* | libm.so.* | libpthread.so.* | libdl.so.* | librt.so.* | ld-linux*.so.*) echo libc6 ;;
    *) die "no package is known for the library $1; add it to tools/make_notice.sh" ;;
  esac
}

# Folder below /usr/include -> package, for libraries that are compiled in from their headers.
package_of_headers() {
  case $1 in
    boost) echo libboost1.74-dev ;;
    CLI) echo libcli11-dev ;;
    nlohmann) echo nlohmann-json3-dev ;;
    X11) echo x11proto-dev ;;
    alsa | xcb | espeak-ng | gtest | gmock | rapidcheck) ;;  # their libraries are above, or are for tests only
    bits | sys | gnu | arpa | net | netinet | netpacket | rpc | linux | asm | asm-generic | scsi | mtd | *-linux-gnu | *-linux-gnueabihf | c++) ;;  # libc6-dev
    *) die "no package is known for the headers in /usr/include/$1; add it to tools/make_notice.sh" ;;
  esac
}

packages() {
  local name
  # In every program: the C library and what the compiler adds.
  printf '%s\n' libc6-dev "libstdc++-12-dev$cross" "libgcc-12-dev$cross" espeak-ng-data
  for name in $(ninja -C "$build" -t commands robot_programs | grep -oE '/[^ ]*/lib[^ /]+\.(a|so)[.0-9]*' | sed 's,.*/,,' | sort -u); do
    package_of_library "$name"
  done
  for name in $(cd "$build/bundle/sound" && ls -d -- *.so*); do package_of_library "$name"; done
  for name in $(ninja -C "$build" -t deps 2>/dev/null | grep -oE '/usr/include/[^ /]+/' | cut -d/ -f4 | sort -u); do
    package_of_headers "$name"
  done
}

copyright_of() { # PACKAGE
  local file=/usr/share/doc/$1/copyright
  [ -r "$file" ] || die "there is no $file on this machine, and the robot's programs contain $1; install it: sudo apt-get install $1"
  echo "$file"
}

# The sysroot has the i386 packages of the same release of Debian.
version_of() { dpkg-query -W -f '${Version}' "$1"; }
licences_of() { sed -n 's/^License: *\([^ ].*\)/\1/p' "$1" | sort -u; }
json() { printf '"%s"' "$(printf '%s' "$1" | sed 's/[\\"]/\\&/g')"; }

found=$(packages)
mapfile -t all < <(sort -u <<<"$found")
[ ${#all[@]} -ge 15 ] || die "only ${#all[@]} packages found; is $build a finished robot build?"
version=$(cat "$build/VERSION")

{
  printf 'darwinop-rt %s for the robot contains, besides its own programs (LICENSE), software of others. Their notices follow.\n' "$version"
  printf 'The sources are in Debian 12: apt-get source PACKAGE.\n\n'
  printf '  %s\n' "${all[@]}"
  for package in "${all[@]}"; do
    file=$(copyright_of "$package")
    printf '\n======== %s %s\n\n' "$package" "$(version_of "$package")"
    cat "$file"
  done
  # Debian's files refer to these texts.
  for package in "${all[@]}"; do grep -oE '/usr/share/common-licenses/[A-Za-z]+(-[0-9.]*[0-9])?' "$(copyright_of "$package")" || true; done |
    sort -u | while read -r text; do
      printf '\n======== %s\n\n' "$text"
      cat "$text"
    done
} >"$folder/NOTICE"

{
  printf '{\n  "bomFormat": "CycloneDX",\n  "specVersion": "1.5",\n  "version": 1,\n'
  printf '  "metadata": {"component": {"type": "application", "name": "darwinop-rt", "version": %s}},\n  "components": [' "$(json "$version")"
  separator=
  for package in "${all[@]}"; do
    package_version=$(version_of "$package")
    printf '%s\n    {"type": "library", "name": %s, "version": %s, "purl": %s, "licenses": [' "$separator" "$(json "$package")" \
      "$(json "$package_version")" "$(json "pkg:deb/debian/$package@${package_version//+/%2B}?distro=debian-12")"
    comma=
    while read -r licence; do
      printf '%s{"license": {"name": %s}}' "$comma" "$(json "$licence")"
      comma=', '
    done < <(licences_of "$(copyright_of "$package")")
    printf ']}'
    separator=,
  done
  printf '\n  ]\n}\n'
} >"$folder/sbom.cdx.json"
