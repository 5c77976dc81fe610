// One implementation of a conversion, for tests and benchmarks that cover all of them.
#pragma once

#include <span>
#include <string_view>

namespace darwinop::pixels {

template <class Function>
struct Kernel {
  std::string_view name;
  Function* function;
  bool usable;  // on this CPU
};

/// Sorted from slow to fast on this CPU; the first one, plain C++, is usable everywhere.
template <class Function>
const Kernel<Function>& fastest(std::span<const Kernel<Function>> kernels) noexcept {
  const Kernel<Function>* best = &kernels.front();
  for (const Kernel<Function>& kernel : kernels)
    if (kernel.usable) best = &kernel;
  return *best;
}

}  // namespace darwinop::pixels
