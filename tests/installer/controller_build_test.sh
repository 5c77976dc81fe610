#!/usr/bin/env bash
# Cross-compiling a controller on the PC: built, unchanged and rejected files. Needs no robot.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
installer=$(readlink -f "$here/../../installer")
# shellcheck source=../../installer/pc/messages.sh
. "$installer/pc/messages.sh"
command -v i686-linux-gnu-g++ >/dev/null || { echo "not on this machine: i686-linux-gnu-g++. Install: g++-i686-linux-gnu"; exit 1; }
LAB=$(mktemp -d)
trap 'rm -rf "$LAB"' EXIT
export SOURCE; SOURCE=$(readlink -f "$here/../..")
# shellcheck source=controller_sources.sh
. "$here/controller_sources.sh"
make_sdk "$LAB/sdk"

fail() { echo "FAIL $scenario: $*"; [ ! -s "$LAB/said" ] || sed 's/^/  /' "$LAB/said"; exit 1; }

# build_controller FOLDER: as in `darwinop install`, in dash and with compiler variables of a PC. Sets $status and $program.
build_controller() {
  status=0
  # shellcheck disable=SC2016  # dash reads it
  CXXFLAGS=-march=native TARGET=other DARWINOP_ROBOT_SDK=${sdk:-$LAB/sdk} XDG_CACHE_HOME=$LAB/cache dash -c '
    set -u
    installer=$1
    for part in "$installer"/pc/*.sh; do . "$part"; done
    compile_controller "$2"
    printf "%s\n" "$controller_program"' - "$installer" "$1" >"$LAB/program" 2>"$LAB/said" || status=$?
  program=$(cat "$LAB/program")
}
expect() { [ "$status" = "$1" ] || fail "status $status instead of $1"; }
expect_said() { grep -qE -- "$1" "$LAB/said" || fail "not said: $1"; }

scenario_a_folder_without_makefile_becomes_one_program() {
  controller walker 'return helper();' 'int helper();'
  echo 'int helper() { return 21; }' >"$LAB/pc/walker/helper.cpp"
  find "$LAB/pc/walker" | sort >"$LAB/before"
  build_controller "$LAB/pc/walker"
  expect 0
  result=0; "$program" || result=$?
  [ $result = 21 ] || fail "the program does not run"
  [ "${program##*/}" = walker ] || fail "the program is called ${program##*/}"
  find "$LAB/pc/walker" | sort | cmp -s - "$LAB/before" || fail "the source folder was changed"
}

scenario_unchanged_sources_are_not_built_again() {
  controller walker 'return 1;'
  build_controller "$LAB/pc/walker"
  before=$(stat -c %Y.%i "$program" "${program%/*}/main.o")
  sleep 1.1
  touch "$LAB/pc/walker/main.cpp"
  build_controller "$LAB/pc/walker"
  [ "$(stat -c %Y.%i "$program" "${program%/*}/main.o")" = "$before" ] || fail "it was rebuilt"
}

scenario_a_source_that_came_back_from_a_backup_is_built() {
  controller walker 'return 1;'
  build_controller "$LAB/pc/walker"
  controller walker 'return 2;'
  touch -d 2001-01-01 "$LAB/pc/walker/main.cpp"
  build_controller "$LAB/pc/walker"
  result=0; "$program" || result=$?
  [ $result = 2 ] || fail "the old program was kept"
}

scenario_a_removed_source_is_not_linked() {
  controller walker 'return 1;'
  echo 'struct S { S(); } s; S::S() { throw 1; }' >"$LAB/pc/walker/other.cpp"
  build_controller "$LAB/pc/walker"
  rm "$LAB/pc/walker/other.cpp"
  build_controller "$LAB/pc/walker"
  result=0; "$program" || result=$?
  [ $result = 1 ] || fail "the removed source is still in the program"
}

scenario_its_own_makefile_is_used() {
  controller walker 'return ANSWER;'
  for makefile in darwin-op robotis-op2; do
    rm -f "$LAB/pc/walker"/Makefile.*
    printf 'CXX = g++\nTARGET = stroll\nCXXFLAGS += -DANSWER=33\ninclude ../Makefile.include\n' >"$LAB/pc/walker/Makefile.$makefile"
    echo 'all: ; false' >"$LAB/pc/walker/Makefile"
    build_controller "$LAB/pc/walker"
    expect 0
    result=0; "$program" || result=$?
    [ $result = 33 ] || fail "Makefile.$makefile was not used"
  done
}

# As from before September 2013: folders and libraries of Webots and ROBOTIS, a rule of its own, a library of its own.
scenario_a_full_makefile_with_absolute_paths_is_built() {
  controller walker 'return answer() + helper() + Robot().value + WALKS;' '#include <webots/Robot.hpp>
#include "answer.h"
extern "C" int helper();'
  mkdir -p "$LAB/sdk/include/darwinop/webots"
  echo 'struct Robot { int value = 20; };' >"$LAB/sdk/include/darwinop/webots/Robot.hpp"
  echo 'int helper(void) { return 3; }' >"$LAB/pc/walker/helper.c"
  cat >"$LAB/pc/walker/Makefile.darwin-op" <<'END'
TARGET = stroll
include $(WEBOTS_HOME)/resources/Makefile.os.include
CXX_SOURCES = main.cpp
ifndef WEBOTS_HOME
$(error WEBOTS_HOME is not set)
endif
CXX = /usr/bin/g++ -DWALKS=4
CC = gcc
INCLUDE_DIRS = -I/darwin/Linux/include -I /darwin/Framework/include -I$(WEBOTS_HOME)/include/controller/cpp -I../../include
CXXFLAGS = -O2 -m32 -DLINUX -DCROSSCOMPILATION -Wall -Werror $(INCLUDE_DIRS)
LIBS = /darwin/Linux/lib/darwin.a ../../lib/managers.a ../../transfer/lib/wrapper.a /usr/lib/libX11.so.6
OBJECTS = $(CXX_SOURCES:.cpp=.o)
all: $(TARGET)
darwin.a:
	$(MAKE) -C /darwin/Linux/build
answer.h:
	echo 'inline int answer() { int unused; return 10; }' >$@
main.o: answer.h
libown.a: helper.o
	ar rcs $@ $^
$(TARGET): darwin.a $(OBJECTS) libown.a $(LIBS)
	$(CXX) $(CXXFLAGS) -o $(TARGET) $(OBJECTS) $(LIBS) libown.a -L/darwin/lib -lX11 -lpthread -ljpeg -lrt
	chmod 755 $(TARGET)
END
  build_controller "$LAB/pc/walker"
  expect 0
  result=0; "$program" || result=$?
  [ $result = 37 ] || fail "the program returns $result"
  [ "${program##*/}" = stroll ] || fail "the program is called ${program##*/}"
  for replaced in -I/darwin/Linux/include -I/usr/local/webots/include/controller/cpp /darwin/Linux/lib/darwin.a \
    ../../lib/managers.a /usr/lib/libX11.so.6 -ljpeg 'make -C /darwin/Linux/build'; do
    expect_said "Makefile.darwin-op: .*$replaced"
  done
  [ "$(grep -c '^Makefile.darwin-op: ' "$LAB/said")" = 1 ] || fail "it is not one line"
  rm -r "$LAB/sdk/include/darwinop/webots"
}

scenario_an_absolute_path_to_makefile_include_is_replaced() {
  controller walker 'return ANSWER;'
  printf 'CXXFLAGS += -DANSWER=12\ninclude /usr/local/webots/darwin-op/Makefile.include\n' >"$LAB/pc/walker/Makefile.darwin-op"
  build_controller "$LAB/pc/walker"
  expect 0
  result=0; "$program" || result=$?
  [ $result = 12 ] || fail "the program returns $result"
}

scenario_compilers_of_other_computers_are_replaced() {
  controller walker 'return 6;'
  printf 'CROSS = i586-geode-linux-\nwalker: main.cpp\n\t$(CROSS)g++ -c main.cpp\n\t/opt/bin/g++-4.4 main.o -o walker\n' \
    >"$LAB/pc/walker/Makefile.darwin-op"
  build_controller "$LAB/pc/walker"
  expect 0
  result=0; "$program" || result=$?
  [ $result = 6 ] || fail "the program returns $result"
}

scenario_a_makefile_for_the_old_libraries_is_left_aside() {
  controller walker 'return 3;'
  printf 'all:\n\tg++ main.cpp /robotis/Linux/lib/darwin.a -o walker\n' >"$LAB/pc/walker/Makefile.robotis-op2"
  build_controller "$LAB/pc/walker"
  expect 0
  expect_said "$msg_instead"
}

scenario_warnings_are_shown_without_failure() {
  controller walker 'int unused; return 0;'
  build_controller "$LAB/pc/walker"
  expect 0
  expect_said 'main.cpp:[0-9]+:[0-9]+: warning: unused variable'
}

scenario_errors_end_it_with_the_compilers_lines() {
  controller walker 'return nonsense;'
  build_controller "$LAB/pc/walker"
  expect 1
  expect_said 'main.cpp:[0-9]+:[0-9]+: error: .nonsense. was not declared'
  expect_said 'walker does not compile'
}

scenario_a_program_of_the_pc_is_never_sent() {
  controller walker 'return 0;'
  g++ "$LAB/pc/walker/main.cpp" -o "$LAB/pc/walker/walker"
  build_controller "$LAB/pc/walker"
  expect 0
  cmp -s "$program" "$LAB/pc/walker/walker" && fail "the student's own build would be sent"
  # Names that only the shell can read; the last program requires a loader.
  for compiler in "/usr/bin/g'+'+" "/usr/bin/g'+'+ -static" "i686-linux-gnu-g'+'+ -no-pie"; do
    printf 'all:\n\t%s main.cpp -o walker\n' "$compiler" >"$LAB/pc/walker/Makefile.darwin-op"
    build_controller "$LAB/pc/walker"
    expect 1
    expect_said "$msg_not_static"
    rm -rf "$LAB/cache"
  done
}

scenario_blanks_and_umlauts_in_the_folders_name_work() {
  controller 'Mein Läufer $1 #2' 'return 5;'
  build_controller "$LAB/pc/Mein Läufer \$1 #2"
  expect 0
  result=0; "$program" || result=$?
  [ $result = 5 ] || fail "it does not run"
}

scenario_what_cannot_be_sent_is_refused_first() {
  controller walker 'return 0;'
  ln -s nowhere "$LAB/pc/walker/sound.wav"
  build_controller "$LAB/pc/walker"
  expect 1
  expect_said 'sound.wav is a link that leads nowhere'
  rm "$LAB/pc/walker/sound.wav"
  ln -s .. "$LAB/pc/walker/round"
  build_controller "$LAB/pc/walker"
  expect 1
  expect_said 'loop'
  rm "$LAB/pc/walker/round"
  mkfifo "$LAB/pc/walker/pipe"
  build_controller "$LAB/pc/walker"
  expect 1
  expect_said "$msg_not_file"
}

scenario_a_controller_in_python_is_refused_with_what_runs_it() {
  mkdir -p "$LAB/pc/walker"
  echo 'from controller import Robot' >"$LAB/pc/walker/walk.py"
  for what in walker walker/walk.py missing.py; do
    sdk=$LAB/none build_controller "$LAB/pc/$what"
    expect 1
    script=$LAB/pc/${what%walk.py}
    [ "$what" = missing.py ] || script=$LAB/pc/walker/walk.py
    expect_said "darwinop run --robot tcp://darwin@192.168.123.1 $script\$"
    [ "$(wc -l <"$LAB/said")" = 1 ] || fail "it is not one line"
  done
  controller walker 'return 7;'  # a folder with both is compiled
  build_controller "$LAB/pc/walker"
  expect 0
}

scenario_without_library_or_sources_it_says_what_to_do() {
  controller walker 'return 0;'
  sdk=$LAB/none build_controller "$LAB/pc/walker"
  expect 1
  expect_said './dev build --robot'
  sdk=$LAB/none build_controller "$LAB/pc/missing"  # before the library, which may have to come from the robot
  expect 1
  expect_said "$msg_no_folder"
  mkdir -p "$LAB/pc/empty"
  build_controller "$LAB/pc/empty"
  expect 1
  expect_said "$msg_nothing_to_build"
}

# shellcheck disable=SC2046  # one name a line
[ $# -gt 0 ] || set -- $(sed -n 's/^scenario_\([a-zA-Z0-9_]*\)().*/\1/p' "$0")
for scenario; do
  rm -rf "$LAB/pc" "$LAB/cache"
  "scenario_$scenario"
  echo "ok   $scenario"
done
