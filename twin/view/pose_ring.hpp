// Poses on their way from the thread that moves the robot to the one that draws it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "twin/render/pose.hpp"

namespace darwinop::twin {

/// One pushing and one popping thread; neither waits. What does not fit is dropped and counted.
class PoseRing {
 public:
  static constexpr std::uint32_t kRoom = 8192;  // over four minutes of a film that is drawn late

  void push(const Pose& pose) noexcept {
    const std::uint32_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - popped_.load(std::memory_order_acquire) == kRoom) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    poses_[pushed % kRoom] = pose;
    pushed_.store(pushed + 1, std::memory_order_release);
  }

  /// False: there is none.
  bool pop(Pose& pose) noexcept {
    const std::uint32_t popped = popped_.load(std::memory_order_relaxed);
    if (pushed_.load(std::memory_order_acquire) == popped) return false;
    pose = poses_[popped % kRoom];
    popped_.store(popped + 1, std::memory_order_release);
    return true;
  }

  /// All that were ever pushed, dropped ones too.
  [[nodiscard]] std::uint32_t offered() const noexcept { return pushed_.load(std::memory_order_relaxed) + dropped(); }
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint32_t> pushed_{0}, popped_{0}, dropped_{0};
  std::array<Pose, kRoom> poses_{};
};

}  // namespace darwinop::twin
