#!/usr/bin/env bash
# upward_includes.sh COMPILER LIST [ROOT]: does an include of a room that is not used fail to compile, for every room?
# LIST, made by CMake: a line for each room, PATH|include directories with : between them. For each room one tiny source
# asks for every header of the tree: those of used rooms must be found, the others not. Its last line includes one of
# those others, and must be the only error.
set -euo pipefail
compiler=$1 list=$2
cd "${3:-$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
wrong() {
  echo "$1" >&2
  failed=1
}

# ROOM OTHER, for each room that ROOM reaches, itself included.
awk -F ' *[|] *' '/^[0-9]/ {
  reach[$2] = " " $2 " "
  count = split($3, used, " ")
  for (i = 1; i <= count; i++) {
    sub(/^~/, "", used[i])
    more = split(reach[used[i]], below, " ")
    for (k = 1; k <= more; k++) if (!index(reach[$2], " " below[k] " ")) reach[$2] = reach[$2] below[k] " "
  }
  more = split(reach[$2], below, " ")
  for (k = 1; k <= more; k++) print $2, below[k]
}' tools/cmake/rooms.table >"$work/reach"

cut -d '|' -f 1 "$list" | while read -r room; do
  for header in "$room"/*.hpp "$room.hpp"; do [ ! -e "$header" ] || echo "$room $header"; done
done >"$work/headers"

rooms=0
while IFS='|' read -r room directories; do
  rooms=$((rooms + 1))
  source=$work/upward.cpp
  awk -v room="$room" '
    FILENAME ~ /reach$/ { if ($1 == room) mine[$2] = 1; next }
    $1 in mine { printf "#if !__has_include(\"%s\")\n#error %s cannot include %s, which it uses\n#endif\n", $2, room, $2; next }
    # The last one is not asked for first: g++ 12 then passes over an include that fails.
    upward { printf "#if __has_include(\"%s\")\n#error %s can include %s, which it does not use\n#endif\n", upward, room, upward }
    { upward = $2 }
    END { printf "#include \"%s\"\n", upward }' "$work/reach" "$work/headers" >"$source"
  upward=$(tail -n 1 "$source" | cut -d '"' -f 2)
  [ -n "$upward" ] || { wrong "$room uses every room" && continue; }
  includes=()
  IFS=: read -ra folders <<<"$directories"
  for folder in "${folders[@]}"; do includes+=("-I$folder"); done
  if LC_ALL=C "$compiler" -std=c++20 -fsyntax-only "${includes[@]}" "$source" 2>"$work/errors"; then
    wrong "$room: an include of $upward compiles"
    continue
  fi
  grep 'error:' "$work/errors" | grep -v "fatal error: .*$upward" >"$work/others" || :  # no message of ours
  [ ! -s "$work/others" ] || wrong "$(sed 's/.*error: //' "$work/others")"
  grep -q "fatal error: .*$upward" "$work/errors" || wrong "$room: $upward failed to compile for another reason"  # no message of ours
done <"$list"
[ $rooms -ge 30 ] || wrong "only $rooms rooms in $list"
[ $failed = 0 ] && echo "$rooms rooms: no include leads to a room that is not used"
exit $failed
