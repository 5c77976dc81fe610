// Counts what a thread takes from the heap. A test program that uses it links allocation_probe.cpp.
#pragma once

namespace darwinop {

/// Calls of operator new by the calling thread so far.
long allocationsOfThisThread();

}  // namespace darwinop
