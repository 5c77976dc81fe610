#!/usr/bin/env bash
# Prints docs/architecture.md with the rooms of tools/cmake/rooms.table, diagram and table, between its marks.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
table=tools/cmake/rooms.table

# A line a floor, highest first; hal/* stands for the rooms in hal/ on that floor.
diagram() {
  echo '```'
  awk -F ' *[|] *' '/^[0-9]/ {
    top = $2
    sub(/\/.*/, "", top)
    if (++rooms[$1, top] == 1) { tops[$1] = tops[$1] " " top; name[$1, top] = $2 } else name[$1, top] = top "/*"
    if ($1 > highest) highest = $1
  }
  END {
    for (floor = highest; floor >= 0; floor--) {
      line = "floor " floor
      count = split(tops[floor], names, " ")
      for (i = 1; i <= count; i++) line = line "   " name[floor, names[i]]
      print line
    }
  }' $table
  echo '```'
}

rows() {
  printf 'Room|What lives there\n---|---\n'
  awk -F ' *[|] *' '/^[0-9]/ {
    if (floor == "" || $1 != floor) printf "**floor %s**|\n", $1
    floor = $1
    printf "`%s%s`%s|%s%s\n", $2, system("test -d " $2) ? "" : "/", $5 ~ /(^| )pc( |$)/ ? "\\*" : "", $7, $6 == "" ? "" : "; **never** " $6
  }' $table
}

part() { case $1 in diagram) diagram ;; table) rows ;; esac; }

while IFS= read -r line; do
  case $line in
    '<!-- rooms: '*' -->')
      printf '%s\n' "$line"
      skip=${line#<!-- rooms: } skip=${skip% -->}
      part "$skip"
      ;;
    '<!-- end of rooms -->') skip= && printf '%s\n' "$line" ;;
    *) [ -n "${skip:-}" ] || printf '%s\n' "$line" ;;
  esac
done <docs/architecture.md
