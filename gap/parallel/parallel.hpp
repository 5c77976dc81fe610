// Parallel for loop over threads.
#pragma once

#include <cstddef>
#include <functional>

namespace darwinop::gap {

/// Threads that forEach() may use; 0: as many as the machine has. For the whole program; set it before work begins.
void setThreads(unsigned threads);

/// Calls work(i) for every i below `count`, in any order, in several threads; returns when all are done. The first
/// exception is passed on. Called from inside itself it works in the calling thread alone.
void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace darwinop::gap
