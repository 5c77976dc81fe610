# Cross build for a robot with a 64-bit ARM board, such as a Raspberry Pi 3 or later. See robot.cmake.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(ROBOT_DEBIAN_ARCHITECTURE arm64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(ROBOT_COMPILER aarch64-linux-gnu-)
# As on the PC: no fused multiply-add, which rounds once instead of twice, and a char with a sign.
set(ROBOT_COMPILE_FLAGS "-march=armv8-a -ffp-contract=off -fsigned-char")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(ROBOT_STATIC_PIE ON)
include("${CMAKE_CURRENT_LIST_DIR}/robot.cmake")
