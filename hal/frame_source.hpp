// Where pictures come from: a camera on the robot, or the twin's head.
#pragma once

#include <cstdint>
#include <span>

#include "hal/byte_line.hpp"

namespace darwinop {

/// What the bytes of a picture are.
enum class PictureForm : std::uint8_t {
  kBgra,  // as a controller gets it: four bytes a pixel, blue, green, red, 255; top row first, no gaps
  kYuyv,  // as the camera gives it, upside down, hal/pixels/yuyv_image.hpp; no gaps. For encoders
};

/// One of `bgra` and `yuyv` is empty.
struct CameraFrame {
  std::uint64_t sequence = 0;  // 0: there is none yet; a jump: frames between were lost
  Nanos time{0};               // when it was taken, on the source's clock
  int width = 0, height = 0;
  std::span<const std::uint8_t> bgra{};
  std::span<const std::uint8_t> yuyv{};
};

/// What has happened to a source since it was made. All but `seeing` only grow.
struct CameraHealth {
  bool seeing = false;        // a frame came within the last 2 s
  std::uint64_t frames = 0;   // whole ones
  std::uint64_t dropped = 0;  // the camera counted them and we never got them
  std::uint64_t damaged = 0;  // too short, or marked bad by the driver; never shown
  std::uint64_t reopened = 0;
};

/// Used by one thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// The newest complete frame; the same one again when nothing newer is there. Its bytes stay as they are until the
  /// next call. Never waits.
  virtual CameraFrame newest() = 0;
  [[nodiscard]] virtual CameraHealth health() const = 0;
};

}  // namespace darwinop
