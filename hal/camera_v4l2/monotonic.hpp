// CLOCK_MONOTONIC, the clock of V4L2 timestamps.
#pragma once

#include <chrono>
#include <ctime>

namespace darwinop::v4l2 {

[[nodiscard]] inline std::chrono::nanoseconds monotonicNow() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

}  // namespace darwinop::v4l2
