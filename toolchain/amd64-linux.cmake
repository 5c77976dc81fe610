# Cross build for a robot with a 64-bit PC board: any x86-64 processor. See robot.cmake.
set(CMAKE_SYSTEM_PROCESSOR amd64)
set(ROBOT_DEBIAN_ARCHITECTURE amd64)
set(CMAKE_LIBRARY_ARCHITECTURE x86_64-linux-gnu)
set(ROBOT_COMPILER x86_64-linux-gnu-)
set(ROBOT_COMPILE_FLAGS "-march=x86-64")
set(ROBOT_STATIC_PIE ON)
include("${CMAKE_CURRENT_LIST_DIR}/robot.cmake")
