# Cross build for a robot with a 32-bit ARM system on ARMv7 with NEON: Raspberry Pi 2, 3, Zero 2 and later. See robot.cmake.
set(CMAKE_SYSTEM_PROCESSOR armhf)
set(ROBOT_DEBIAN_ARCHITECTURE armhf)
set(CMAKE_LIBRARY_ARCHITECTURE arm-linux-gnueabihf)
set(ROBOT_COMPILER arm-linux-gnueabihf-)
# As on the PC: no fused multiply-add, which rounds once instead of twice, and a char with a sign. -Wno-psabi: g++ 7
# passed some classes otherwise; nothing here comes from it.
set(ROBOT_COMPILE_FLAGS "-march=armv7-a+simd -mfloat-abi=hard -ffp-contract=off -fsigned-char -Wno-psabi")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm)
# Debian has no rcrt1.o for it, so addresses of the programs do not differ from start to start; those of stack and heap do.
set(ROBOT_STATIC_PIE OFF)
include("${CMAKE_CURRENT_LIST_DIR}/robot.cmake")
