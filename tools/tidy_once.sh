#!/usr/bin/env bash
# clang-tidy for one file, unless it has had nothing to say about exactly this text before.
# usage: tidy_once.sh BUILD_FOLDER FILE
set -euo pipefail
build=$1 file=$2
known=${XDG_CACHE_HOME:-$HOME/.cache}/darwinop-rt/tidy

# Some rooms share precompiled headers that have Eigen, without using it; here those headers are read again.
eigen=-isystem/usr/include/eigen3

# What the compiler would see, comments included: they may silence a check.
text=$(awk -v wanted="$file" '
  /"directory":/ { split($0, d, "\"") } /"command":/ { c = $0 }
  /"file":/ { split($0, f, "\""); if (f[4] == wanted) { print d[4]; print c; exit } }' "$build/compile_commands.json")
folder=${text%%$'\n'*}
command=$(sed -E 's/^ *"command": "//; s/",?$//; s/\\"/"/g; s/^[^ ]*ccache //; s/ -Xclang -include-pch -Xclang [^ ]+//; s/ -o [^ ]+ -c / -E -C -o - /' <<<"${text#*$'\n'}")
sum=$({
  clang-tidy --version
  cat .clang-tidy tests/.clang-tidy
  (cd "$folder" && sh -c "$command $eigen") | sed "s|$PWD||g"  # the same in every clone
} | sha256sum)
sum=${sum%% *}
[ ! -e "$known/$sum" ] || exit 0
clang-tidy -p "$build" --quiet --extra-arg="$eigen" "$file"
mkdir -p "$known"
touch "$known/$sum"
