// "A cycle is finished": waking and waiting across processes by futex. No system call when nobody waits.
#pragma once

#include <atomic>
#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

/// A number that only goes up, and sleepers who want to know. Lies in shared memory. A sleeper that is killed stays
/// counted: from then on each advance() makes its system call, to no harm.
class WakeWord {
 public:
  /// One thread only: stores the next value and wakes whoever sleeps.
  void advance() noexcept;
  [[nodiscard]] std::uint32_t value() const noexcept { return value_.load(std::memory_order_acquire); }
  /// Sleeps until the value is no longer `seen`, a signal comes, or `at_most` is over. May return early.
  void waitWhile(std::uint32_t seen, Nanos at_most) noexcept;

 private:
  std::atomic<std::uint32_t> value_{0};
  std::atomic<std::uint32_t> sleepers_{0};  // how many may be asleep
};

}  // namespace darwinop::runtime
