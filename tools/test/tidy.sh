#!/usr/bin/env bash
# clang-tidy on what changed; `tidy.sh all`: on everything.
#
# Changed is what differs from the merge base with origin/main. On main itself: what the last commits changed, at most 20 of
# them and at most 40 files, whichever comes first. DARWINOP_TIDY_BASE=COMMIT says it otherwise.
# builds: asan-ubsan all fuzzers precompiled_headers
# computes only
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. tools/test/ctest.sh
builds
build=build/asan-ubsan
ln -sfn ../../../tests/.clang-tidy "$build/tests/.clang-tidy"

changed_since() { # COMMIT: sources that differ from it; not those that only moved
  {
    git diff --name-status "$1" -- '*.cpp' '*.hpp' | awk -F '\t' '!/^(D|R100)/ { print $NF }'
    git ls-files --others --exclude-standard -- '*.cpp' '*.hpp'
  } | sort -u
}

base() {
  local commit head older
  head=$(git rev-parse HEAD)
  commit=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null || echo "$head")
  if [ "$commit" = "$head" ]; then
    while read -r older; do
      [ "$commit" = "$head" ] || [ "$(changed_since "$older" | wc -l)" -le 40 ] || break
      commit=$older
    done < <(git rev-list --first-parent --skip=1 --max-count=20 HEAD)
  fi
  echo "$commit"
}

# The units (files that the compiler gets: unity batches, mostly) of this build. With a list of changed files on stdin: each
# unit that contains a changed .cpp, and for each changed header one unit that includes it.
units_of_all() { sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build/compile_commands.json" | grep -vE "cmake_pch|_headers\.cpp$" | sort -u; }
units_of_changed() {
  cat >"$build/changed"
  ninja -C "$build" -t deps | awk '
    NR == FNR { changed[$0]; next }
    /^[^ ]/ { unit = ""; next }
    NF {
      if (unit == "") {  # the first source among the dependencies is the unit itself
        if ($1 !~ /\.c(pp|xx)$/ || $1 ~ /cmake_pch|_headers\.cpp$/) next
        unit = $1
      }
      n = split($1, part, "/")
      path = part[n]
      for (i = n - 1; i > 0; --i) {
        path = part[i] "/" path
        if (!(path in changed)) continue
        if (path ~ /\.cpp$/) chosen[unit]; else users[path] = users[path] " " unit
      }
    }
    END {
      for (header in users) {
        n = split(users[header], unit_of, " ")
        for (i = 1; i <= n; ++i) if (unit_of[i] in chosen) break
        if (i > n) chosen[unit_of[1]]
      }
      for (unit in chosen) print unit
    }' "$build/changed" - | (cd "$build" && xargs -r realpath) | sort -u
}

if [ "${1:-}" = all ]; then
  mapfile -t units < <(units_of_all)
else
  since=${DARWINOP_TIDY_BASE:-$(base)}
  mapfile -t changed < <(changed_since "$since")
  units=()
  [ ${#changed[@]} = 0 ] || mapfile -t units < <(printf '%s\n' "${changed[@]}" | units_of_changed)
  say "tidy: ${#changed[@]} files changed since $(git log -1 --format='%h (%s)' "$since"), in ${#units[@]} units"
fi
[ ${#units[@]} != 0 ] || exit 0
printf '%s\n' "${units[@]}" | nice xargs -P "$(nproc)" -n 1 tools/tidy_once.sh "$build" 2> >(grep -vE '^[0-9]+ warnings?' >&2)
