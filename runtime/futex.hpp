// "A cycle is finished": waking and waiting across processes by futex. No system call when nobody waits.
#pragma once

#include <atomic>
#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

/// Which value the sleepers wait for. The sleepers write it, in memory that they may write. It is a hint: a wrong one
/// costs a sleeper its time-out once, or the loop one system call a cycle.
class WaitNote {
 public:
  void waitFor(std::uint32_t value) noexcept { value_.store(value); }
  /// Somebody has noted this value or one shortly before it. Several sleepers write here, and one of them may be late.
  [[nodiscard]] bool isAwaited(std::uint32_t value) const noexcept { return value - value_.load() < kShortly; }

 private:
  static constexpr std::uint32_t kShortly = 4;  // values
  std::atomic<std::uint32_t> value_{0};
};

/// A number that only goes up, and sleepers who want to know. Sleepers only read it: their mapping may be read-only.
class WakeWord {
 public:
  /// One thread only: stores the value and wakes the waiting threads.
  void set(std::uint32_t value, const WaitNote& note) noexcept;
  [[nodiscard]] std::uint32_t value() const noexcept { return value_.load(std::memory_order_acquire); }
  /// Sleeps until the value is no longer `seen`, a signal comes, or `at_most` is over. May return early.
  void waitWhile(std::uint32_t seen, Nanos at_most, WaitNote& note) const noexcept;

 private:
  std::atomic<std::uint32_t> value_{0};
};

}  // namespace darwinop::runtime
