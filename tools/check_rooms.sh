#!/usr/bin/env bash
# check_rooms.sh [ROOT]: do the sources keep to tools/cmake/rooms.table? No #include may lead to a room that its own room
# does not use, no use may lead upward, and what a room must never hold is not in it. Prints each violation with file
# and line. `ctest -R Rooms` runs it; tests/rooms has a small tree with every kind of violation.
set -euo pipefail
cd "${1:-$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/..}"
table=tools/cmake/rooms.table
[ -r $table ] || { echo "cannot read $PWD/$table" >&2 && exit 2; }

# Sets `pattern` to a word of the column "never" as an extended regular expression of code without comments.
never() {
  case $1 in
    'I/O') pattern='#include <(iostream|fstream|filesystem|ostream|istream|fcntl\.h|unistd\.h|poll\.h|dirent\.h|termios\.h|sys/[a-z]+\.h)>|\b(fopen|fread|fwrite|fprintf|printf|puts|perror|std::cout|std::cerr)\b' ;;
    threads) pattern='#include <(thread|mutex|shared_mutex|condition_variable|future|semaphore|latch|barrier|stop_token|pthread\.h)>' ;;
    clocks) pattern='\b(steady_clock|system_clock|high_resolution_clock|clock_gettime|gettimeofday)\b|#include <(ctime|time\.h)>' ;;
    heap) pattern='#include <(string|vector|map|set|deque|list|memory|functional|unordered_map)>|\b(malloc|calloc|new)\b' ;;
    sockets) pattern='#include <(sys/socket\.h|netinet/[a-z]+\.h|arpa/inet\.h|netdb\.h)>|#include <boost/|#include "hal/net/' ;;
    'device files') pattern='"/dev/(tty|video|snd|input|bus)|#include <(termios\.h|linux/(videodev2|serial|input|tty)[a-z_]*\.h)>' ;;
    'Webots names') pattern='#include [<"]webots/|\bwebots::|\bDARwInOP|\bRobotisOp2' ;;
    MuJoCo) pattern='#include <mujoco/|\bmj[A-Z][A-Za-z]*\b|\bmj_[a-z]' ;;
    bus) pattern='#include "hal/(servo_bus|cm730/)|\bServoBus\b' ;;
    lease) pattern='#include "runtime/(lease|daemon_link)' ;;
    'robot data') pattern='#include "core/|#include "runtime/|\b(JointRow|kJointTable)\b' ;;
    logic) pattern='' ;;  # for people to judge
    *) return 1 ;;
  esac
}

violations=$(
  # Every source of the tree but tests, tools and examples, which may use all rooms.
  find . -path ./build -prune -o -path ./tests -prune -o -path ./tools -prune -o -path ./controllers -prune -o \
    -path './.*' -prune -o -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) -print | sed 's:^\./::' | sort |
    xargs awk -F ' *[|] *' '
      function folder(path) { return path ~ /\// ? substr(path, 1, match(path, /\/[^\/]*$/) - 1) : "" }
      function top(path) { sub(/\/.*/, "", path); return path }
      function roomOf(path,  stem) {  # a file of its own in the table, or its folder
        stem = path
        sub(/\.[a-z]+$/, "", stem)
        return stem in floor ? stem : folder(path)
      }
      function home(path) {  # the room of a file
        sub(/^webots\/include\/webots(\/utils)?\//, "webots/", path)
        sub(/^managers\/include\//, "managers/", path)
        return roomOf(path)
      }
      FILENAME == table {
        if ($0 !~ /^[0-9]/) next
        if (NF != 7) { print table ":" FNR ": a row has seven fields, this one has " NF; next }
        room = $2
        if (room in floor) print table ":" FNR ": " room " stands here twice"
        if ($1 + 0 < highest) print table ":" FNR ": " room " stands below the row before it"
        highest = $1 + 0
        floor[room] = $1 + 0
        if ($3 == "*") { all[room] = 1; next }
        count = split($3, used, " ")
        for (i = 1; i <= count; i++) {
          other = used[i]
          sub(/^~/, "", other)
          if (!(other in floor)) print table ":" FNR ": " room " uses " other ", which does not come before it"
          else if (floor[other] == floor[room] && top(other) != top(room))
            print table ":" FNR ": " room " uses " other ", which stands on the same floor"
          uses[room, other] = FNR
        }
        next
      }
      FNR == 1 {
        file = FILENAME
        sub(/^\.\//, "", file)
        here = home(file)
        if (!(here in floor)) print file ":1: the folder " here " is not a room of " table
        built[here] = 1
      }
      /^[ \t]*#[ \t]*include[ \t]*["<]/ || /__has_include/ {
        target = $0
        sub(/^[^"<]*["<]/, "", target)
        sub(/[">].*/, "", target)
        if (target ~ /^webots\//) there = "webots"
        else if (target ~ /^(DARwInOP|RobotisOp2)/) there = "managers"
        else if ($0 ~ /"/ && target ~ /\//) there = roomOf(target)
        else next
        if (!(there in floor)) {
          if ($0 ~ /"/) print file ":" FNR ": " target " is in no room"
          next
        }
        if (there == here || (here in all)) next
        needed[here, there] = 1
        if (!((here, there) in uses))
          print file ":" FNR ": " here " (floor " floor[here] ") does not use " there " (floor " floor[there] "): " target
      }
      END {
        for (room in floor) if (!(room in built)) print table ": the room " room " has no sources"
        for (pair in uses) {
          split(pair, two, SUBSEP)
          if (!((two[1], two[2]) in needed)) print table ":" uses[pair] ": " two[1] " includes nothing of " two[2]
        }
      }' table=$table $table
  while IFS='|' read -r floor room _ _ _ words _; do
    room=${room// /}
    if [ "$floor" -lt 6 ]; then words+=", Webots names"; fi
    IFS=, read -ra words <<<"$words"
    for word in "${words[@]}"; do
      word=$(sed 's/^ *//; s/ *$//' <<<"$word")
      [ -n "$word" ] || continue
      never "$word" || { echo "$table: no meaning of \"$word\" in tools/check_rooms.sh"; continue; }
      [ -n "$pattern" ] || continue
      { [ ! -d "$room" ] || find "$room" -maxdepth 1 \( -name '*.cpp' -o -name '*.hpp' \) -print0
        [ -d "$room" ] || printf '%s\0' "$room".?pp; } | xargs -0r grep -HnE "$pattern" |
        sed 's:[ \t]*//.*::' | grep -E ":[0-9]+:.*($pattern)" | sed "s|\$|  <- $room: never $word|" || :
    done
  done < <(grep '^[0-9]' $table)
)
[ -z "$violations" ] || { printf '%s\n' "$violations" && exit 1; }
echo "$(grep -c '^[0-9]' $table) rooms keep to $table"
