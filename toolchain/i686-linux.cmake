# Cross build for the robot's 32-bit Atom Z530: static programs that need neither loader nor library there.
#
#   cmake -S . -B build/robot -DCMAKE_TOOLCHAIN_FILE=toolchain/i686-linux.cmake     (preset "robot" says the same)
#
# ROBOT_SYSROOT, a CMake variable or one of the environment, names the i386 sysroot; unset: make-sysroot.sh makes it.
# A controller that builds with CMake gives -DCMAKE_PREFIX_PATH=build/robot/sdk also.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR i686)
set(CMAKE_LIBRARY_ARCHITECTURE i386-linux-gnu)

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ROBOT_SYSROOT)
if(NOT ROBOT_SYSROOT AND DEFINED ENV{ROBOT_SYSROOT})
  set(ROBOT_SYSROOT "$ENV{ROBOT_SYSROOT}")
endif()
if(NOT ROBOT_SYSROOT)
  execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/make-sysroot.sh" OUTPUT_VARIABLE ROBOT_SYSROOT
    OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT ROBOT_SYSROOT OR NOT EXISTS "${ROBOT_SYSROOT}/usr/include/stdio.h")
  message(FATAL_ERROR "There is no i386 sysroot at '${ROBOT_SYSROOT}'; toolchain/make-sysroot.sh makes one or prints why not")
endif()
set(CMAKE_SYSROOT "${ROBOT_SYSROOT}")

set(CMAKE_C_COMPILER i686-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER i686-linux-gnu-g++)

# The Z530 has SSE up to SSSE3. With x87 arithmetic, results would differ from those on the PC.
#
# static-pie: a static program at an address that differs from start to start, as the kernel's randomisation says. An
# ET_DYN file without an interpreter is what the loader ld-linux.so.2 itself is, and every kernel since 1.0 runs that as
# a program; the program relocates itself (glibc >= 2.26). In kernels before 5.2 its heap may have little room behind it;
# malloc() then uses mmap(), and so does the C library at start-up (glibc >= 2.36, Debian 12).
set(ROBOT_COMPILE_FLAGS "-march=bonnell -mfpmath=sse -fpie")
set(ROBOT_LINK_FLAGS "-static-pie")
set(CMAKE_C_FLAGS_INIT "${ROBOT_COMPILE_FLAGS}")
set(CMAKE_CXX_FLAGS_INIT "${ROBOT_COMPILE_FLAGS}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "${ROBOT_LINK_FLAGS}")
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)

# Headers and libraries come from the sysroot and from where the caller says, programs from this machine.
set(CMAKE_FIND_ROOT_PATH "${ROBOT_SYSROOT}" ${CMAKE_PREFIX_PATH})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_DIR} "")
set(ENV{PKG_CONFIG_LIBDIR} "${ROBOT_SYSROOT}/usr/lib/i386-linux-gnu/pkgconfig:${ROBOT_SYSROOT}/usr/share/pkgconfig")
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${ROBOT_SYSROOT}")
