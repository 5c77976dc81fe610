#!/usr/bin/env bash
# Prints docs/architecture.md with the rooms of tools/cmake/rooms.table, diagram and table, between its marks.
# print_rooms.sh --dot [FOLDER]: prints the graph of their includes for Graphviz's dot, a row a floor, those that go upward in
# red; with FOLDER (gap) only the rooms below it, in the order of the table.
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

# The room of a file or of an included header is the longest name in the table that is a folder above it.
graph() {
  { sed -n 's/^[0-9].*/&/p' $table && git grep -oE '^#include "[a-z0-9_]+/[^"]+' -- '*.hpp' '*.cpp' ':!tests' ':!controllers'; } |
    awk -v folder="${1:-}" '
    function room(path) {
      while (sub(/\/[^\/]*$/, "", path)) if (path in floor) return path
      return ""
    }
    function shown(name) { return name != "" && (folder == "" || index(name "/", folder "/") == 1) }
    / [|] / { split($0, column, / *[|] */); floor[column[2]] = column[1]; order[column[2]] = ++rooms; next }
    {
      split($0, part, /:#include "/)
      from = room(part[1]); to = room(part[2])
      if (from != to && shown(from) && shown(to)) edge[from " " to]
    }
    END {
      print "digraph rooms {\n  rankdir = BT; ranksep = 1; node [shape = box, fontname = Helvetica];"
      for (name in floor) if (shown(name)) row[floor[name]] = row[floor[name]] " \"" name "\";"
      if (folder == "") for (level in row) printf "  { rank = same;%s }\n", row[level]
      else for (level in row) print " " row[level]
      for (pair in edge) {
        split(pair, end, " ")
        upward = floor[end[1]] < floor[end[2]] || (floor[end[1]] == floor[end[2]] && order[end[1]] < order[end[2]])
        printf "  \"%s\" -> \"%s\"%s;\n", end[2], end[1], upward ? " [color = red, penwidth = 3]" : ""
      }
      print "}"
    }'
}
if [ "${1:-}" = --dot ]; then
  graph "${2:-}"
  exit
fi

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
