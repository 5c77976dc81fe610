#!/bin/bash
# Installs the package to a place of its own and builds controllers against it in every way that is promised.
#   build_controllers.sh BUILD_DIRECTORY SOURCE_DIRECTORY
set -euo pipefail
build=$1
source=$2
: "${CMAKE:=cmake}" "${CXX:=c++}" "${CXXFLAGS:=}" "${LDFLAGS:=}"
export CXX

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
step() { echo "== $*"; }

# Runs a controller on the robot in memory for a moment; Ctrl-C must end it with status 0.
runs() {
  local status=0
  # --foreground: one signal, to the program alone; a second one ends it at once.
  DARWINOP_ROBOT=virtual timeout --foreground --preserve-status --signal=INT --kill-after=20 1 "$1" >"$work/out" 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    echo "$1 ended with status $status:"
    cat "$work/out"
    exit 1
  fi
}

# The prefix is moved after the install: nothing in it may remember where it was.
step "install"
"$CMAKE" --install "$build" --component sdk --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/prefix"
prefix=$work/prefix

step "find_package(darwinop)"
cp -r "$source/controllers/02_symmetry" "$work/cmake_way"
cat "$source/tests/package/crosscompilation.inc" >>"$work/cmake_way/02_symmetry.cpp"
"$CMAKE" -S "$work/cmake_way" -B "$work/cmake_way/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="$CXXFLAGS" \
  >"$work/cmake.log"
"$CMAKE" --build "$work/cmake_way/build" >>"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
runs "$work/cmake_way/build/02_symmetry"

step "pkg-config darwinop, each of our controllers in the style of 2013 (C++98) and of today (C++17)"
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name darwinop.pc)")
for style in 2013:c++98 today:c++17; do
  for folder in "$source/tests/webots/api/${style%%:*}"/*/; do
    program=$work/pkg_config_way/${style%%:*}/$(basename "$folder")
    mkdir -p "$program"
    # shellcheck disable=SC2046,SC2086  # flags are lists of words
    "$CXX" -std="${style##*:}" -Wall -Werror $CXXFLAGS "$folder"*.cpp $(pkg-config --cflags --libs darwinop) $LDFLAGS \
      -include "$source/tests/package/crosscompilation.inc" -o "$program/controller"
    runs "$program/controller"
    if [ "$(basename "$folder")" = walk ] && [ ! -e /darwin/Data ] && [ ! -e /robotis/Data ] &&
      ! grep -q "darwinop motion list own" "$work/out"; then
      echo "there are no pages in the library:"
      cat "$work/out"
      exit 1
    fi
  done
done

# One line in the controller's folder, as in 2013; the program is called as its folder.
step "Makefile.darwin-op beside the installed Makefile.include"
makefile=$(find "$prefix" -name Makefile.include)
make_way() { # FOLDER NAME=VALUE...
  local controllers=$1
  shift
  mkdir -p "$controllers/symmetry"
  cp "$source/tests/webots/api/2013/symmetry/"* "$controllers/symmetry"
  echo 'include ../Makefile.include' >"$controllers/symmetry/Makefile.darwin-op"
  make -s -C "$controllers/symmetry" -f Makefile.darwin-op "$@" CXXFLAGS="$CXXFLAGS" CFLAGS="$CXXFLAGS" LFLAGS="$LDFLAGS"
  runs "$controllers/symmetry/symmetry"
  make -s -C "$controllers/symmetry" -f Makefile.darwin-op "$@" clean
  [ ! -e "$controllers/symmetry/symmetry" ] || { echo "make clean left the program"; exit 1; }
}
mkdir -p "$work/linked" "$work/copied"
ln -s "$makefile" "$work/linked/Makefile.include"
make_way "$work/linked"

step "made for another computer: made again, and nothing twice"
made=$work/linked/symmetry
make_it() { make -C "$made" -f Makefile.darwin-op CXXFLAGS="$CXXFLAGS $*" CFLAGS="$CXXFLAGS" LFLAGS="$LDFLAGS" >"$work/made"; }
make_it
make_it
! grep -q -e ' -c ' "$work/made" || { echo "made twice:"; cat "$work/made"; exit 1; }
make_it -DTHE_OTHER="'1 2'"
[ "$(grep -c -e "THE_OTHER='1 2' .*-c " "$work/made")" = 2 ] || { echo "not made again:"; cat "$work/made"; exit 1; }

step "the same with WEBOTS_DARWINOP_PROJECT_ROOT"
cp "$makefile" "$work/copied/Makefile.include"
make_way "$work/copied" WEBOTS_DARWINOP_PROJECT_ROOT="$prefix"

step "the same in the tree of the robot, with DARWINOP_ROOT"
mkdir -p "$work/darwin/Linux/project"
cp -r "$prefix" "$work/darwin/Linux/project/webots"
mkdir -p "$work/darwin/Linux/project/webots/controllers"
cp "$makefile" "$work/darwin/Linux/project/webots/controllers/Makefile.include"
make_way "$work/darwin/Linux/project/webots/controllers" DARWINOP_ROOT="$work/darwin"

step "plain make, with a full Makefile of before September 2013"
mkdir -p "$work/full"
cp "$source/tests/webots/api/2013/symmetry/"* "$work/full"
cat >"$work/full/Makefile.darwin-op" <<'END'
TARGET = symmetry
CXX = g++
CXXFLAGS = -O2 -DLINUX -DCROSSCOMPILATION -Wall -Werror -I/darwin/Linux/include -I$(WEBOTS_HOME)/include/controller/cpp $(OF_THE_TEST)
OBJECTS = main.o Symmetry.o
all: $(TARGET)
darwin.a:
	make -C /darwin/Linux/build
$(TARGET): darwin.a $(OBJECTS) ../../transfer/lib/wrapper.a
	$(CXX) $(OF_THE_TEST) ../../transfer/lib/wrapper.a /darwin/Linux/lib/darwin.a -o $@ $(OBJECTS) -lpthread -ljpeg -lrt
END
old_make=$(find "$prefix" -name old-make)
(cd "$work/full" && PATH=$(dirname "$old_make")/bin:$PATH make -f Makefile.darwin-op -s OF_THE_TEST="$CXXFLAGS $LDFLAGS") 2>"$work/said" ||
  { cat "$work/said"; exit 1; }
grep -q '^Makefile.darwin-op: .*/darwin/Linux/lib/darwin.a' "$work/said" || { cat "$work/said"; exit 1; }
runs "$work/full/symmetry"

echo "all ways work"
