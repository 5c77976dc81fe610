#!/usr/bin/env bash
# Does tools/check_rooms.sh find what it is for? A small tree with one violation of every kind.
set -euo pipefail
check=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../tools/check_rooms.sh")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
mkdir -p tools/cmake core hal/a hal/b safety webots

table() {
  cat >tools/cmake/rooms.table <<'END'
0 | core | | | robot | I/O, threads, clocks, heap | facts
1 | safety | core | | robot | I/O | limits
2 | hal/a | core | | robot | | a device
2 | hal/b | hal/a | | robot | device files | another
2 | hal/one | hal/b | | robot | threads | a file of its own
6 | webots | hal/one hal/b safety core | | robot | | the API
END
}
good() {
  table
  echo '#include <array>  // no <thread>' >core/joints.hpp
  echo '#include "core/joints.hpp"' >safety/guard.hpp
  echo '#include "core/joints.hpp"' >hal/a/a.hpp
  echo '#include "hal/a/a.hpp"' >hal/b/b.hpp
  echo '#include "hal/b/b.hpp"' >hal/one.hpp
  printf '#include "%s"\n' hal/one.hpp hal/b/b.hpp safety/guard.hpp core/joints.hpp >webots/robot.cpp
  rm -rf attic
}
fails=0
# expect "MESSAGE" SHELL: after this change of the valid tree the check fails with this message.
expect() {
  local said
  good
  eval "$2"
  if said=$("$check" "$tree"); then
    echo "not found: $2" && fails=1
  elif ! grep -qF -- "$1" <<<"$said"; then
    printf '%s\nshould say: %s\nsaid: %s\n' "$2" "$1" "$said" && fails=1
  fi
}

good
"$check" "$tree" >/dev/null || { echo "the good tree fails:" && "$check" "$tree" || exit 1; }
expect 'safety/guard.hpp:2: safety (floor 1) does not use webots' 'echo "#include \"webots/robot.hpp\"" >>safety/guard.hpp'
expect 'safety (floor 1) does not use webots' 'echo "#include <webots/Robot.hpp>" >>safety/guard.hpp'
expect 'hal/b (floor 2) does not use core' 'echo "#include \"core/joints.hpp\"" >>hal/b/b.hpp'
expect 'hal/one (floor 2) does not use hal/a' 'echo "#include \"hal/a/a.hpp\"" >>hal/one.hpp'
expect 'hal/b (floor 2) does not use hal/one' 'echo "#include \"hal/one.hpp\"" >>hal/b/b.hpp'
expect 'hal/one: never threads' 'echo "#include <mutex>" >>hal/one.hpp'
expect 'attic/x.hpp is in no room' 'echo "#include \"attic/x.hpp\"" >>webots/robot.cpp'
expect 'the folder attic is not a room' 'mkdir attic; echo "int x;" >attic/x.cpp'
expect 'webots includes nothing of safety' 'sed -i /safety/d webots/robot.cpp'
expect 'safety uses hal/a, which does not come before it' 'sed -i "s/safety | core/safety | hal\/a core/" tools/cmake/rooms.table'
expect 'hal/b uses safety, which stands on the same floor' 'sed -i "s/^1 /2 /; s/b | hal/b | safety hal/" tools/cmake/rooms.table'
expect 'hal/a stands below the row before it' 'sed -i "s/^1 /3 /" tools/cmake/rooms.table'
expect 'core stands here twice' 'echo "6 | core | | | robot | | again" >>tools/cmake/rooms.table'
expect 'the room attic has no sources' 'echo "6 | attic | | | robot | | nothing" >>tools/cmake/rooms.table'
expect 'a row has seven fields' 'echo "6 | attic | | | nothing" >>tools/cmake/rooms.table'
expect 'no meaning of "smoke"' 'sed -i "s/device files/smoke/" tools/cmake/rooms.table'
expect 'core: never threads' 'echo "#include <thread>" >>core/joints.hpp'
expect 'core: never heap' 'echo "int* leak() { return new int; }" >>core/joints.hpp'
expect 'core: never clocks' 'echo "auto t = std::chrono::steady_clock::now();" >>core/joints.hpp'
expect 'core: never I/O' 'echo "#include <iostream>" >>core/joints.hpp'
expect 'safety: never I/O' 'echo "void say() { printf(\"hello\"); }" >>safety/guard.hpp'
expect 'safety: never Webots names' 'echo "void f(webots::Motor&);" >>safety/guard.hpp'
expect 'hal/b: never device files' 'echo "auto p = \"/dev/ttyUSB0\";" >>hal/b/b.hpp'
[ $fails = 0 ] && echo "every kind of violation is found"
exit $fails
