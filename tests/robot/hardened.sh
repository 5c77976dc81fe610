#!/usr/bin/env bash
# hardened.sh BUILD [static|static-fixed]: is every program of that build that is shipped hardened as
# tools/cmake/Hardening.cmake says? static: as on a robot, nothing but darwinop-sound asks for a loader. static-fixed: nor
# is it position-independent (toolchain/armhf-linux.cmake). NM: of the build's architecture.
set -euo pipefail
build=$1 kind=${2:-}
nm() { command "${NM:-nm}" "$@"; }
bind_now='BIND_NOW\|Flags:.* NOW'
[ "$kind" != static-fixed ] || bind_now+='\|no dynamic section'
failed=0
fail() { echo "hardened.sh: $1: $2" >&2; failed=1; }

check() { # PROGRAM
  local name=${1##*/} header segments dynamic symbols
  header=$(readelf -hW "$1") segments=$(readelf -lW "$1") dynamic=$(readelf -dW "$1") symbols=$(nm "$1"; nm -D "$1" 2>/dev/null)
  [ "$kind" = static-fixed ] || grep -q 'Type: *DYN' <<<"$header" ||
    fail "$name" "not position-independent: its addresses are the same at each start"
  grep -q 'GNU_RELRO' <<<"$segments" || fail "$name" "no RELRO: its linkage table stays writable"
  grep -q "$bind_now" <<<"$dynamic" || fail "$name" "no BIND_NOW"
  grep -q 'GNU_STACK.* RW ' <<<"$segments" || fail "$name" "the stack is executable, or nothing is stated about it"
  ! grep -q 'LOAD.* RWE ' <<<"$segments" || fail "$name" "a segment is writable and executable"
  ! grep -q 'TEXTREL' <<<"$dynamic" || fail "$name" "relocations in its code"
  grep -q '__stack_chk_fail' <<<"$symbols" || fail "$name" "no stack protector"
  [[ "$kind" != static* ]] || [ "$name" = darwinop-sound ] || ! grep -q INTERP <<<"$segments" ||
    fail "$name" "asks for a loader"
}

programs=0
for program in "$build"/bin/darwinop "$build"/bin/darwinop-*; do
  if [ -f "$program" ] && [ "$(head -c 4 "$program")" = $'\x7fELF' ]; then
    check "$program"
    programs=$((programs + 1))
  fi
done
[ $programs -ge 10 ] || fail "$build/bin" "only $programs programs are there; build robot_programs, or all"

# The C library's own checked calls are in every static program: our code has to ask for them itself.
for room in runtime hal_cm730 core_text; do
  undefined=$(nm -u "$build/lib/lib$room.a" 2>/dev/null)
  grep -q '__stack_chk_fail' <<<"$undefined" || fail "lib$room.a" "compiled without -fstack-protector-strong"
done
undefined=$(nm -u "$build/lib/libruntime.a" "$build/lib/libconnect.a" 2>/dev/null)
grep -q '_chk$' <<<"$undefined" || fail libruntime.a "compiled without FORTIFY"

[ $failed = 0 ] || exit 1
echo "$programs programs are hardened"
