#!/usr/bin/env bash
# Each installed header compiles by itself, and all of them together, as the C++98 of the robot's compiler, with every
# warning that a user may turn on.
#   headers_alone.sh SOURCE_DIRECTORY
set -euo pipefail
cd "$1"
: "${CXX:=c++}"

compiles() { # HEADER
  "$CXX" -std=c++98 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Iwebots/include -Imanagers/include -x c++ "$1"
}

# A header that needs another one has to be found.
lame=$(mktemp --suffix=.hpp)
trap 'rm -f "$lame"' EXIT
echo 'inline std::string name() { return "NeckS"; }' >"$lame"
! compiles "$lame" 2>/dev/null || { echo "$lame compiles without <string>" && exit 1; }

failed=0
while IFS= read -r header; do
  compiles "$header" || failed=1
done < <(find webots/include managers/include -name '*.hpp')

# All of them, with all namespaces opened at once, as upstream's examples do.
all=$(mktemp --suffix=.cpp)
trap 'rm -f "$lame" "$all"' EXIT
find "$PWD/webots/include" "$PWD/managers/include" -name '*.hpp' | sort | sed 's/.*/#include "&"/' >"$all"
echo 'using namespace std; using namespace webots; using namespace managers; Robot *robot; Node *node; Motion *motion;' >>"$all"
compiles "$all" || failed=1
exit $failed
