// Tells damaged pictures from a broken device where both are errors of reading.
#pragma once

#include <chrono>

namespace darwinop::v4l2 {

/// Linux 2.6.31 reports each damaged picture as EIO, and a bad stretch of cable costs many in a row: they come at the
/// pace of pictures. A device that is broken answers every read at once.
class ErrorBurst {
 public:
  /// After a picture that could be read.
  void over() noexcept { count_ = 0; }

  /// True: more errors than pictures can have come, even if this thread was late and found all buffers waiting.
  [[nodiscard]] bool add(std::chrono::nanoseconds now) noexcept {
    if (count_ == 0 || now - begun_ >= kSpan) {
      begun_ = now;
      count_ = 0;
    }
    return ++count_ > kMost;
  }

 private:
  static constexpr std::chrono::milliseconds kSpan{100};  // three pictures of 30 a second; four buffers may wait
  static constexpr int kMost = 8;
  std::chrono::nanoseconds begun_{0};
  int count_ = 0;
};

}  // namespace darwinop::v4l2
