# Cross build for the robot's 32-bit Atom Z530. See robot.cmake.
#
#   cmake -S . -B build/robot -DCMAKE_TOOLCHAIN_FILE=toolchain/i686-linux.cmake     (preset "robot" says the same)
set(CMAKE_SYSTEM_PROCESSOR i686)
set(ROBOT_DEBIAN_ARCHITECTURE i386)
set(CMAKE_LIBRARY_ARCHITECTURE i386-linux-gnu)
set(ROBOT_COMPILER i686-linux-gnu-)
# The Z530 has SSE up to SSSE3. With x87 arithmetic, results would differ from those on the PC.
set(ROBOT_COMPILE_FLAGS "-march=bonnell -mfpmath=sse")
set(ROBOT_STATIC_PIE ON)
include("${CMAKE_CURRENT_LIST_DIR}/robot.cmake")
