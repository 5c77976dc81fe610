# shellcheck shell=bash disable=SC2154  # $LAB and $SOURCE are set by who sources this
# Sources of test controllers, and an empty library to build them with. Sourced by controller_*.sh.

# controller NAME BODY [BEFORE]: a folder $LAB/pc/NAME with the source of a program; BEFORE stands above main.
controller() {
  mkdir -p "$LAB/pc/$1"
  printf '%s\n' '#include <csignal>' '#include <cstdio>' '#include <unistd.h>' 'volatile sig_atomic_t stopped = 0;' \
    'void stop(int) { stopped = 1; }' "${3:-}" "int main(int argc, char** argv) { $2 }" >"$LAB/pc/$1/main.cpp"
  printf '[Robot Config]\ntime_step = 16\n' >"$LAB/pc/$1/config.ini"
}

# The layout that ./dev build --robot makes, with the true Makefile.include.
make_sdk() {
  local sdk=$1
  mkdir -p "$sdk/lib" "$sdk/share/darwinop" "$sdk/include/darwinop"
  rm -f "$sdk/lib/libdarwinop.a"
  ar rc "$sdk/lib/libdarwinop.a"
  sed 's/@CMAKE_INSTALL_LIBDIR@/lib/; s/@CMAKE_INSTALL_DATADIR@/share/; s/@CMAKE_INSTALL_INCLUDEDIR@/include/
    s/@CMAKE_INSTALL_PREFIX@//; s/@DARWINOP_OTHER_FLAGS@//' "$SOURCE/tools/cmake/Makefile.include.in" >"$sdk/share/darwinop/Makefile.include"
  install -m 755 "$SOURCE/tools/cmake/old-make.sh" "$sdk/share/darwinop/old-make"
  printf '%s\n' 'CXX := i686-linux-gnu-g++' 'ROBOT_CXXFLAGS := -march=bonnell -mfpmath=sse -fpie' \
    'ROBOT_LFLAGS := -static-pie' >"$sdk/share/darwinop/robot-toolchain.mk"
}
