// Maps the driver's sequence numbers to those of CameraFrame and CameraHealth.
#pragma once

#include <cstdint>

namespace darwinop::v4l2 {

/// CameraFrame::sequence starts at 1 and jumps where pictures were lost. The driver's count wraps, may start anywhere,
/// and restarts when the camera is reopened.
class FrameCount {
 public:
  struct Number {
    std::uint64_t sequence = 0;
    std::uint64_t dropped = 0;  // counted by the driver just before this picture but never delivered
  };

  /// The device was reopened; an unknown number of pictures was lost.
  void restart() noexcept {
    if (last_ != 0) ++last_;
    first_ = true;
    unnumbered_ = 0;
  }

  /// The driver reported a damaged picture without its number: the next gap includes it.
  void unnumbered() noexcept { ++unnumbered_; }

  Number next(std::uint32_t drivers) noexcept {
    std::uint32_t step = first_ ? 1 : drivers - drivers_;
    // A count that stalls or decreases is ignored.
    if (step == 0 || step > kBackwards) step = 1;
    const std::uint32_t lost = step - 1;
    const std::uint32_t dropped = lost > unnumbered_ ? lost - unnumbered_ : 0;
    last_ += step;
    drivers_ = drivers;
    first_ = false;
    unnumbered_ = 0;
    return {last_, dropped};
  }

 private:
  static constexpr std::uint32_t kBackwards = 0x8000'0000u;
  std::uint64_t last_ = 0;
  std::uint32_t drivers_ = 0, unnumbered_ = 0;
  bool first_ = true;
};

}  // namespace darwinop::v4l2
