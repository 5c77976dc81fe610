// Waking and waiting across processes by futex.
#include "runtime/futex.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>

namespace darwinop::runtime {
namespace {
// What SYS_futex takes on i386 and amd64, whatever the C library's time_t is.
struct KernelTimespec {
  long seconds, nanoseconds;
};
}  // namespace

// Both sides write one word and then look at the other, in the one order that seq_cst gives. So either advance()
// sees the sleeper and wakes it, or the kernel sees the new value and does not put the sleeper to bed. A mere flag
// that advance() clears would not do: cleared between the sleeper's look and its sleep, it is missing next time.
void WakeWord::advance() noexcept {
  value_.store(value_.load(std::memory_order_relaxed) + 1);
  if (sleepers_.load() != 0) syscall(SYS_futex, &value_, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

void WakeWord::waitWhile(std::uint32_t seen, Nanos at_most) noexcept {
  constexpr long long a_second = 1'000'000'000;
  const KernelTimespec timeout{static_cast<long>(at_most.count() / a_second),
                               static_cast<long>(at_most.count() % a_second)};
  sleepers_.fetch_add(1);
  if (value_.load() == seen) syscall(SYS_futex, &value_, FUTEX_WAIT, seen, &timeout, nullptr, 0);
  sleepers_.fetch_sub(1);
}

}  // namespace darwinop::runtime
