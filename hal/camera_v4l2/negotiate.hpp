// Agrees with a device on what its pictures are like.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "hal/camera_v4l2/device.hpp"

namespace darwinop::v4l2 {

struct Size {
  int width = 0, height = 0;  // pixels
  bool operator==(const Size&) const = default;
};

/// What every camera of the robot can do (thesis, table 4.1).
inline constexpr Size kFallback{320, 240};

[[nodiscard]] std::string text(Size size);

/// Pictures of YUYV: two bytes a pixel.
struct PictureShape {
  Size size;
  std::size_t stride = 0;  // bytes from a row to the next
};

/// Told sentences that are no trouble, but worth knowing.
using Remark = std::function<void(const std::string&)>;

/// No cropping, YUYV, 30 pictures a second, and the size wanted; a device that does not give it is asked for
/// kFallback, and what it gives then is taken. Throws CameraRefused.
[[nodiscard]] PictureShape negotiate(const Device& device, Size wanted, const Remark& remark);

}  // namespace darwinop::v4l2
