# shellcheck shell=bash
# Installs Debian packages. Sourced from the top folder of the repository.

say() { printf '%s\n' "dev: $*" >&2; }
die() {
  say "$*"
  exit 1
}

packages() { grep -v '^#' tools/packages.txt; }  # needed by | package | why

installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ] ||
    { [ "$1" = npm ] && command -v npm >/dev/null; }  # other packages of Node.js bring it along
}
has_candidate() { apt-cache policy "$1" 2>/dev/null | grep -q 'Candidate: [^(]'; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

may_install() {
  [ "$(id -u)" = 0 ] && return
  command -v sudo >/dev/null || return 1
  # Without a terminal nobody can type a password.
  if [ -t 0 ]; then sudo -v; else sudo -n true 2>/dev/null; fi
}

apt() {
  local options=(-q -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300)
  [ "${CI:-}" != true ] || options+=(-o Dpkg::Options::=--force-unsafe-io)  # a machine that is thrown away needs no fsync
  as_root env DEBIAN_FRONTEND=noninteractive apt-get "${options[@]}" "$@" </dev/null
}

# need GROUP...: installs the missing packages of these groups. Runs no apt command when none is missing.
need() {
  local group package why missing=()
  command -v dpkg-query >/dev/null ||
    die "this is not a Debian system: install what './dev help packages' lists, then use the CMake presets"
  while IFS='|' read -r group package why; do
    group=${group// /} package=${package// /}
    [[ " $* " == *" $group "* ]] || continue
    installed "$package" && continue
    missing+=("$package")
    say "missing: $package:$why"
  done < <(packages)
  [ ${#missing[@]} = 0 ] && return
  # Names and versions are those of one release.
  local system
  system=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
  [ "$system" = 'debian 12' ] || die "packages are known for Debian 12, and here is $system: use a container of it, such as: \
docker run -it -v \"\$PWD:/src\" -w /src debian:12 ./dev demo"
  local command="apt-get install --no-install-recommends ${missing[*]}"
  may_install || die "no right to install packages here. Ask an administrator for: $command"
  say "running: $command"
  for package in "${missing[@]}"; do
    has_candidate "$package" && continue
    apt update  # the package lists are missing or old
    break
  done
  apt install -y --no-install-recommends "${missing[@]}" || {
    apt update  # a listed version may be gone from the archive
    apt install -y --no-install-recommends "${missing[@]}"
  }
}
