// Wakes and waits across processes by futex.
#include "runtime/futex.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <climits>

namespace darwinop::runtime {
namespace {
// timespec of SYS_futex on i386 and amd64, independent of the C library's time_t.
struct KernelTimespec {
  long seconds, nanoseconds;
};
}  // namespace

// Both sides write one word and then read the other's, in the one order that seq_cst gives. So either set() reads the
// note and wakes the sleeper, or the kernel reads the new value and does not put the sleeper to sleep.
void WakeWord::set(std::uint32_t value, const WaitNote& note) noexcept {
  value_.store(value);
  if (note.isAwaited(value)) syscall(SYS_futex, &value_, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

void WakeWord::waitWhile(std::uint32_t seen, Nanos at_most, WaitNote& note) const noexcept {
  constexpr long long a_second = 1'000'000'000;
  const KernelTimespec timeout{static_cast<long>(at_most.count() / a_second),
                               static_cast<long>(at_most.count() % a_second)};
  note.waitFor(seen + 1);
  if (value_.load() != seen || syscall(SYS_futex, &value_, FUTEX_WAIT, seen, &timeout, nullptr, 0) == 0) return;
  if (errno != EFAULT) return;
  // Linux 2.6.33 to 3.0 refuse FUTEX_WAIT in a read-only mapping.
  const timespec pause{0, 1'000'000};
  nanosleep(&pause, nullptr);
}

}  // namespace darwinop::runtime
