// Interface of a picture source: the robot's camera or the twin's.
#pragma once

#include <cstdint>
#include <span>

#include "hal/byte_line.hpp"

namespace darwinop {

/// Pixel format.
enum class PictureForm : std::uint8_t {
  kBgra,  // for controllers: four bytes per pixel (blue, green, red, 255), top row first, no padding
  kYuyv,  // camera format, upside down (hal/pixels/yuyv_image.hpp), no padding; for encoders
};

/// One of `bgra` and `yuyv` is empty.
struct CameraFrame {
  std::uint64_t sequence = 0;  // 0: none yet; a jump: pictures were lost
  Nanos time{0};               // capture time on the source's clock
  int width = 0, height = 0;
  std::span<const std::uint8_t> bgra{};
  std::span<const std::uint8_t> yuyv{};
};

/// Statistics since construction. All but `seeing` increase monotonically.
struct CameraHealth {
  bool seeing = false;        // a picture arrived within the last 2 s
  std::uint64_t frames = 0;   // complete ones
  std::uint64_t dropped = 0;  // counted by the camera but never received
  std::uint64_t damaged = 0;  // too short, or marked bad by the driver; never shown
  std::uint64_t reopened = 0;
};

/// Used by one thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// The newest complete picture; the previous one if there is no newer. Its bytes are valid until the next call. Never
  /// blocks.
  virtual CameraFrame newest() = 0;
  [[nodiscard]] virtual CameraHealth health() const = 0;
};

}  // namespace darwinop
