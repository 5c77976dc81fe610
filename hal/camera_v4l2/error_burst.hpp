// Distinguishes damaged pictures from a broken device, where both are reported as read errors.
#pragma once

#include <chrono>

namespace darwinop::v4l2 {

/// Linux 2.6.31 reports each damaged picture as EIO, and a bad cable causes many in a row, at the picture rate. A
/// broken device fails every read at once.
class ErrorBurst {
 public:
  /// Call after a successful read.
  void over() noexcept { count_ = 0; }

  /// Returns true if errors come faster than pictures could, even with all buffers full at the start.
  [[nodiscard]] bool add(std::chrono::nanoseconds now) noexcept {
    if (count_ == 0 || now - begun_ >= kSpan) {
      begun_ = now;
      count_ = 0;
    }
    return ++count_ > kMost;
  }

 private:
  static constexpr std::chrono::milliseconds kSpan{
      100};  // three pictures at 30 per second; up to four buffers may be full
  static constexpr int kMost = 8;
  std::chrono::nanoseconds begun_{0};
  int count_ = 0;
};

}  // namespace darwinop::v4l2
