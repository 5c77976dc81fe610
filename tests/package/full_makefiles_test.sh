#!/usr/bin/env bash
# Plain `make -f Makefile.darwin-op` with full Makefiles, written for this test in the styles of before September 2013.
# Needs no library: the package is a header and one function.
#   full_makefiles_test.sh SOURCE_DIRECTORY
set -euo pipefail
source=$1
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT
unset MAKEFLAGS MAKELEVEL MAKEFILES CXX CC CXXFLAGS CFLAGS LFLAGS WEBOTS_HOME DARWINOP_ROOT ROBOTISOP2_ROOT WEBOTS_DARWINOP_PROJECT_ROOT

sdk=$lab/sdk data=$lab/sdk/share/darwinop
mkdir -p "$sdk/lib" "$data/bin" "$sdk/include/darwinop/webots" "$sdk/include/darwinop/managers"
printf '#include <string>\nnamespace webots { struct Robot { int answer(); }; }\n' >"$sdk/include/darwinop/webots/Robot.hpp"
echo 'struct RobotisOp2GaitManager {};' >"$sdk/include/darwinop/managers/RobotisOp2GaitManager.hpp"
printf '#include <webots/Robot.hpp>\nint webots::Robot::answer() { return 30; }\n' >"$lab/robot.cpp"
g++ -I"$sdk/include/darwinop" -c "$lab/robot.cpp" -o "$lab/robot.o"
ar rc "$sdk/lib/libdarwinop.a" "$lab/robot.o"
sed 's/@CMAKE_INSTALL_LIBDIR@/lib/; s/@CMAKE_INSTALL_DATADIR@/share/; s/@CMAKE_INSTALL_INCLUDEDIR@/include/
  s/@CMAKE_INSTALL_PREFIX@//; s/@DARWINOP_OTHER_FLAGS@//' "$source/tools/cmake/Makefile.include.in" >"$data/Makefile.include"
install -m 755 "$source/tools/cmake/old-make.sh" "$data/old-make"
install -m 755 "$source/tools/cmake/make.sh" "$data/bin/make"

fail() { echo "FAIL $style: $*"; sed 's/^/  /' "$lab/said"; exit 1; }

# A controller whose program returns 30, with the Makefile of standard input.
controller() { # STYLE
  style=$1 folder=$lab/controllers/$1
  mkdir -p "$folder"
  cat >"$folder/Makefile.darwin-op"
  printf '%s\n' '#include <webots/Robot.hpp>' '#include <RobotisOp2GaitManager.hpp>' 'int answer();' \
    'int main() { RobotisOp2GaitManager gait; (void)gait; return answer(); }' >"$folder/main.cpp"
  printf '%s\n' '#include <webots/Robot.hpp>' '#ifdef CROSSCOMPILATION' \
    'int answer() { webots::Robot robot; return robot.answer(); }' '#endif' >"$folder/answer.cpp"
}

# make as the user calls it, in the controller's folder. Sets $status.
plain() { # ARGUMENT...
  status=0
  (cd "$folder" && PATH=$data/bin:$PATH make "$@") >"$lab/said" 2>&1 || status=$?
}
builds() { # PROGRAM ARGUMENT...
  local program=$folder/$1 result=0
  shift
  if (cd "$folder" && make "$@") >"$lab/said" 2>&1; then fail "the Makefile needs no help: it tests nothing"; fi
  (cd "$folder" && rm -f ./*.o "$program")
  plain "$@"
  [ $status = 0 ] || fail "status $status"
  "$program" || result=$?
  [ $result = 30 ] || fail "the program returns $result"
}

controller framework <<'END'
TARGET = framework
INCLUDE_DIRS = -I/darwin/Linux/include -I /darwin/Framework/include -I$(WEBOTS_HOME)/include/controller/cpp
CXX = g++
CXXFLAGS += -O2 -m32 -DLINUX -DCROSSCOMPILATION -Wall $(INCLUDE_DIRS)
LFLAGS += -lpthread -ljpeg -lrt
OBJECTS = main.o answer.o
all: $(TARGET)
clean:
	rm -f *.o $(TARGET) core
darwin.a:
	make -C /darwin/Linux/build
$(TARGET): darwin.a $(OBJECTS)
	$(CXX) $(CFLAGS) $(OBJECTS) /darwin/Linux/lib/darwin.a -o $(TARGET) $(LFLAGS)
	chmod 755 $(TARGET)
END
builds framework -f Makefile.darwin-op
builds framework -sf Makefile.darwin-op -j2
plain -f Makefile.darwin-op clean
[ ! -e "$folder/framework" ] || fail "clean left the program"
folder=$lab/controllers builds framework/framework -C framework --file=Makefile.darwin-op
builds framework -fMakefile.darwin-op framework

controller webots_home <<'END'
ifndef WEBOTS_HOME
$(error WEBOTS_HOME must be set)
endif
ifeq ($(wildcard $(ROBOTISOP2_ROOT)/no-such-file),)
include $(WEBOTS_HOME)/resources/Makefile.os.include
endif
CROSS = i586-linux-gnu-
SOURCES := $(wildcard *.cpp)
libanswer.a: answer.o
	$(CROSS)ar rcs $@ $^
%.o: %.cpp /robotis/Framework/include/LinuxDARwIn.h
	$(CROSS)g++ -c -g -I/robotis/Linux/include -isystem $(WEBOTS_HOME)/include -DCROSSCOMPILATION $< -o $@
walker: main.o libanswer.a ../../lib/managers.a
	@$(CROSS)g++ -o $@ main.o libanswer.a -L$(WEBOTS_HOME)/lib -L/robotis/Linux/lib -lController -lCppController -ldarwin ../../lib/managers.a /usr/lib/libX11.so.6
.DEFAULT_GOAL := walker
END
builds walker -f Makefile.darwin-op

controller absolute_compiler <<'END'
OBJS=main.o answer.o
DEFS=-DCROSSCOMPILATION -DLINUX
all : controller
.SUFFIXES: .cpp .o
.cpp.o:
	/opt/cross/bin/g++-4.4 $(DEFS) -I/darwin/Linux/project/webots/transfer/include -c $< -o $@
controller: $(OBJS) ../transfer/lib/wrapper.a
	for part in one; do /usr/bin/i686-pc-linux-gnu-g++ -o $@ $(OBJS) ../transfer/lib/wrapper.a /darwin/Linux/lib/darwin.a -ljpeg; done
	/opt/cross/bin/i686-pc-linux-gnu-strip $@
END
sed -i 's/$/\r/' "$folder/Makefile.darwin-op"
builds controller -f Makefile.darwin-op

controller include_elsewhere <<'END'
CXXFLAGS += -DUNUSED=1
include $(WEBOTS_HOME)/projects/robots/darwin-op/Makefile.include
END
builds include_elsewhere -f Makefile.darwin-op

# The Makefile.include of the parent folder is upstream's, then ours.
controller include_parent <<'END'
include ../Makefile.include
END
echo 'all: ; make -C /darwin/Linux/build' >"$lab/controllers/Makefile.include"
builds include_parent -f Makefile.darwin-op
ln -sf "$data/Makefile.include" "$lab/controllers/Makefile.include"
plain -f Makefile.darwin-op clean all
[ $status = 0 ] || fail "status $status"
[ -x "$folder/include_parent" ] || fail "no program"

# Errors of the compiler are errors of make.
style=errors
echo 'nonsense' >>"$lab/controllers/framework/answer.cpp"
folder=$lab/controllers/framework
plain -f Makefile.darwin-op
[ $status = 2 ] || fail "status $status"

# Anything else goes to the real make.
style=others
# shellcheck disable=SC2016  # make reads it
printf 'all:\n\tcommand -v g++ && echo "$(A) $(MAKECMDGOALS)"\n%%: all ; @:\n' >"$folder/Makefile"
plain 'A=two words' -s goal
{ command -v g++; echo "two words goal"; } | cmp -s - "$lab/said" || fail "another output"
plain -f /nowhere/Makefile.darwin-op
[ $status = 2 ] || fail "status $status"
echo "plain make builds them"
