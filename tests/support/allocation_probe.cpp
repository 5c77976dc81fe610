#include "support/allocation_probe.hpp"

#include <cstdlib>
#include <new>

namespace {
thread_local long allocations = 0;
}

namespace darwinop {
long allocationsOfThisThread() {
  return allocations;
}
}  // namespace darwinop

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}
// Of algorithms that can do without, such as std::stable_sort.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
// Not inlined: g++ would otherwise see free() meet new and warn.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
