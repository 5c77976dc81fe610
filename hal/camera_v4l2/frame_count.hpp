// Numbers of pictures: from what the driver counts to what CameraFrame and CameraHealth promise.
#pragma once

#include <cstdint>

namespace darwinop::v4l2 {

/// CameraFrame::sequence begins at 1 and jumps wherever pictures were lost. The driver's own count wraps, may begin
/// anywhere, and begins anew each time the camera is opened.
class FrameCount {
 public:
  struct Number {
    std::uint64_t sequence = 0;
    std::uint64_t dropped = 0;  // pictures that the driver counted just before this one and never handed over
  };

  /// The device was opened anew; pictures between were lost, nobody knows how many.
  void restart() noexcept {
    if (last_ != 0) ++last_;
    first_ = true;
    unnumbered_ = 0;
  }

  /// The driver reported a damaged picture without its number: the next gap contains it.
  void unnumbered() noexcept { ++unnumbered_; }

  Number next(std::uint32_t drivers) noexcept {
    std::uint32_t step = first_ ? 1 : drivers - drivers_;
    // A count that stands still or runs back tells nothing.
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
