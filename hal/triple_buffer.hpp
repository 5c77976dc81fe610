// Wait-free triple buffer for large values: one writer, one reader, no copy.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace darwinop {

/// Three slots: the writer fills one, the reader reads one, and the third is exchanged atomically. The newest value
/// wins; the reader's value stays unchanged until update().
///
/// runtime::Latest is for small values and many readers; it copies word by word.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& everywhere) : places_{everywhere, everywhere, everywhere} {}

  /// Writing thread only: the slot to fill. Contains a value at least two publications old.
  [[nodiscard]] T& back() noexcept { return places_[back_]; }
  /// Writing thread only: publishes back(); another slot becomes back().
  void publish() noexcept {
    back_ = static_cast<std::uint8_t>(between_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kPlace);
  }

  /// Reading thread only: takes the newest value, if there is one since the last call.
  bool update() noexcept {
    if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = static_cast<std::uint8_t>(between_.exchange(front_, std::memory_order_acq_rel) & kPlace);
    return true;
  }
  /// Reading thread only: the value last taken.
  [[nodiscard]] const T& front() const noexcept { return places_[front_]; }

 private:
  static constexpr std::uint8_t kPlace = 3, kFresh = 4;
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

  std::array<T, 3> places_;
  std::atomic<std::uint8_t> between_{1};  // slot index, plus kFresh if the reader has not taken it
  // Separate cache lines: each is written by its thread at every picture.
  alignas(64) std::uint8_t back_ = 0;   // writer's slot
  alignas(64) std::uint8_t front_ = 2;  // reader's slot
};

}  // namespace darwinop
