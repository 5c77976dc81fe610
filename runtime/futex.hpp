// Wakes waiting processes at the end of a cycle, by futex. No system call if none waits.
#pragma once

#include <atomic>
#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

/// The value that waiting processes expect, written by them into memory that they may write. A hint only: a wrong value
/// costs a waiter one time-out, or the loop one system call per cycle.
class WaitNote {
 public:
  void waitFor(std::uint32_t value) noexcept { value_.store(value); }
  /// True if this value, or one up to kShortly earlier, was noted: several waiters share the note.
  [[nodiscard]] bool isAwaited(std::uint32_t value) const noexcept { return value - value_.load() < kShortly; }

 private:
  static constexpr std::uint32_t kShortly = 4;  // values
  std::atomic<std::uint32_t> value_{0};
};

/// Increasing number that processes can wait for. Waiters only read it: their mapping may be read-only.
class WakeWord {
 public:
  /// One thread only: stores the value and wakes the waiting threads.
  void set(std::uint32_t value, const WaitNote& note) noexcept;
  [[nodiscard]] std::uint32_t value() const noexcept { return value_.load(std::memory_order_acquire); }
  /// Sleeps until the value differs from `seen`, a signal arrives, or `at_most` has passed. May return early.
  void waitWhile(std::uint32_t seen, Nanos at_most, WaitNote& note) const noexcept;

 private:
  std::atomic<std::uint32_t> value_{0};
};

}  // namespace darwinop::runtime
