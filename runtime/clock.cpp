// CLOCK_MONOTONIC.
#include "runtime/clock.hpp"

#include <time.h>

#include <cerrno>

namespace darwinop::runtime {
namespace {
constexpr long long kSecond = 1'000'000'000;
}

Nanos MonotonicClock::now() const noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return Nanos{t.tv_sec * kSecond + t.tv_nsec};
}

void MonotonicClock::sleepUntil(Nanos time) noexcept {
  timespec t{};
  t.tv_sec = static_cast<time_t>(time.count() / kSecond);
  t.tv_nsec = static_cast<long>(time.count() % kSecond);
  // Absolute time: a delay before this call does not shift later releases.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

}  // namespace darwinop::runtime
