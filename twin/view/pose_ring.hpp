// Lock-free ring buffer of poses from the simulation thread to the drawing thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "twin/render/pose.hpp"

namespace darwinop::twin {

/// Single producer, single consumer, wait-free. Poses that do not fit are dropped and counted.
class PoseRing {
 public:
  static constexpr std::uint32_t kCapacity = 8192;  // more than 4 min of film at 30/s

  void push(const Pose& pose) noexcept {
    const std::uint32_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - popped_.load(std::memory_order_acquire) == kCapacity) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    poses_[pushed % kCapacity] = pose;
    pushed_.store(pushed + 1, std::memory_order_release);
  }

  /// False if the ring is empty.
  bool pop(Pose& pose) noexcept {
    const std::uint32_t popped = popped_.load(std::memory_order_relaxed);
    if (pushed_.load(std::memory_order_acquire) == popped) return false;
    pose = poses_[popped % kCapacity];
    popped_.store(popped + 1, std::memory_order_release);
    return true;
  }

  /// Number of poses pushed, including dropped ones.
  [[nodiscard]] std::uint32_t offered() const noexcept { return pushed_.load(std::memory_order_relaxed) + dropped(); }
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint32_t> pushed_{0}, popped_{0}, dropped_{0};
  std::array<Pose, kCapacity> poses_{};
};

}  // namespace darwinop::twin
