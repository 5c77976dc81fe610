// Single-producer single-consumer ring buffer of fixed size; items that do not fit are counted.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace darwinop::runtime {

/// Contains no pointers to heap memory.
template <class T, std::uint32_t N>
class Ring {
  static_assert(N != 0 && (N & (N - 1)) == 0, "a power of two, so that the counters may wrap");

 public:
  /// Pushing thread only. Wait-free. False: full; the item is dropped and counted.
  bool push(const T& item) noexcept {
    const std::uint32_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - popped_.load(std::memory_order_acquire) == N) {
      dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    items_[pushed % N] = item;
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
  }

  /// Popping thread only: the oldest item, or nullptr. It stays valid until pop().
  [[nodiscard]] const T* front() const noexcept {
    const std::uint32_t popped = popped_.load(std::memory_order_relaxed);
    return pushed_.load(std::memory_order_acquire) == popped ? nullptr : &items_[popped % N];
  }
  /// Popping thread only, after front() returned an item.
  void pop() noexcept { popped_.store(popped_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  /// Any thread.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint32_t size() const noexcept {
    const std::uint32_t popped = popped_.load(std::memory_order_acquire);
    return pushed_.load(std::memory_order_acquire) - popped;
  }

 private:
  std::atomic<std::uint32_t> pushed_{0}, popped_{0}, dropped_{0};
  std::array<T, N> items_{};
};

}  // namespace darwinop::runtime
