# Hardening of every program that is shipped. Debug builds, which the tests, sanitizers and fuzzers use, go without:
# FORTIFY needs optimisation, and a sanitizer finds more than a canary does. tests/robot/hardened.sh checks
# the programs.
#
#   stack protector   a return address that was overwritten ends the program instead of being used
#   FORTIFY 3         copies, reads and formats into buffers of known size are checked against that size (glibc)
#   relro, now        the linkage table is read-only before main() begins
#   noexecstack       no code on the stack; also the default, but one assembler file without a note would lose it
#
# Cost, all of it together: a cycle with 20 servos takes 46 533 instead of 42 806 instructions on i686, 9 % (callgrind,
# tests/benchmarks/cycle_instructions.cpp; the board is in memory): a few microseconds of 16 ms.
#
# Position independence is the compilers' default on Debian; toolchain/i686-linux.cmake says it for the robot.
# -D_GLIBCXX_ASSERTIONS is left out: a failed one calls abort() in the loop, and the robot would stay stiff until the
# supervisor has taken over.
set(DARWINOP_HARDENED_COMPILE -fstack-protector-strong)
set(DARWINOP_FORTIFY -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
set(DARWINOP_HARDENED_LINK -Wl,-z,relro,-z,now,-z,noexecstack)

add_compile_options("$<$<NOT:$<CONFIG:Debug>>:${DARWINOP_HARDENED_COMPILE};${DARWINOP_FORTIFY}>")
add_link_options("$<$<NOT:$<CONFIG:Debug>>:${DARWINOP_HARDENED_LINK}>")
