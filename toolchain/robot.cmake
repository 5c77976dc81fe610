# What the toolchain files for robots share: static programs that need neither loader nor library there. Each of those
# files sets, before it includes this one:
#   CMAKE_SYSTEM_PROCESSOR      the name of the architecture in bundles and in ./dev build --robot=NAME
#   ROBOT_DEBIAN_ARCHITECTURE   Debian's name of it
#   CMAKE_LIBRARY_ARCHITECTURE  its folder of libraries
#   ROBOT_COMPILER              what stands before gcc and g++ in the compiler's name
#   ROBOT_COMPILE_FLAGS
#   ROBOT_STATIC_PIE            OFF where Debian's C library cannot do it
#
# ROBOT_SYSROOT, a CMake variable or one of the environment, names the sysroot; unset: make-sysroot.sh makes it.
# A controller that builds with CMake gives -DCMAKE_PREFIX_PATH=build/robot/sdk also.
set(CMAKE_SYSTEM_NAME Linux)

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ROBOT_SYSROOT)
if(NOT ROBOT_SYSROOT AND DEFINED ENV{ROBOT_SYSROOT})
  set(ROBOT_SYSROOT "$ENV{ROBOT_SYSROOT}")
endif()
if(NOT ROBOT_SYSROOT)
  execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/make-sysroot.sh" "${ROBOT_DEBIAN_ARCHITECTURE}"
    OUTPUT_VARIABLE ROBOT_SYSROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT ROBOT_SYSROOT OR NOT EXISTS "${ROBOT_SYSROOT}/usr/include/${CMAKE_LIBRARY_ARCHITECTURE}")
  message(FATAL_ERROR "There is no ${ROBOT_DEBIAN_ARCHITECTURE} sysroot at '${ROBOT_SYSROOT}'; toolchain/make-sysroot.sh ${ROBOT_DEBIAN_ARCHITECTURE} makes one or prints why not")
endif()
set(CMAKE_SYSROOT "${ROBOT_SYSROOT}")

set(CMAKE_C_COMPILER ${ROBOT_COMPILER}gcc)
set(CMAKE_CXX_COMPILER ${ROBOT_COMPILER}g++)

# static-pie: a static program at an address that differs from start to start, as the kernel's randomisation says. An
# ET_DYN file without an interpreter is what the loader ld-linux.so.2 itself is, and every kernel since 1.0 runs that as
# a program; the program relocates itself (glibc >= 2.26). In kernels before 5.2 its heap may have little room behind it;
# malloc() then uses mmap(), and so does the C library at start-up (glibc >= 2.36, Debian 12).
if(ROBOT_STATIC_PIE)
  set(ROBOT_LINK_FLAGS "-static-pie")
  string(APPEND ROBOT_COMPILE_FLAGS " -fpie")
else()
  set(ROBOT_LINK_FLAGS "-static")
  string(APPEND ROBOT_COMPILE_FLAGS " -fno-pie")
endif()
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
set(ENV{PKG_CONFIG_LIBDIR} "${ROBOT_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/pkgconfig:${ROBOT_SYSROOT}/usr/share/pkgconfig")
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${ROBOT_SYSROOT}")
