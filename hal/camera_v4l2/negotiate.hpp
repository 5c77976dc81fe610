// Negotiates cropping, format, size and rate with a V4L2 device.
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

/// Supported by every camera of the robot (thesis, table 4.1).
inline constexpr Size kFallback{320, 240};

[[nodiscard]] std::string text(Size size);

/// YUYV: two bytes per pixel.
struct PictureShape {
  Size size;
  std::size_t stride = 0;  // bytes per row
};

/// Receives informational messages.
using Remark = std::function<void(const std::string&)>;

/// No cropping, YUYV, 30 pictures/s and the wanted size. If the device does not support the size, requests kFallback
/// and accepts what it gives. Throws CameraRefused.
[[nodiscard]] PictureShape negotiate(const V4l2Device& device, Size wanted, const Remark& remark);

}  // namespace darwinop::v4l2
