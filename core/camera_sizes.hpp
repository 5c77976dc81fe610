// Picture sizes of the robot's camera and their frame rates. Source: thesis of 2013, table 4.1.
#pragma once

#include <array>

namespace darwinop {

struct CameraSize {
  int width, height;  // pixels
  double rate_hz;     // maximum
};

inline constexpr std::array<CameraSize, 6> kCameraSizes{
    {{320, 240, 30}, {640, 360, 30}, {640, 400, 30}, {640, 480, 30}, {768, 480, 28}, {800, 600, 22.5}}};

/// Row of a size; null: the robot's camera does not support it.
constexpr const CameraSize* cameraSize(int width, int height) {
  for (const CameraSize& size : kCameraSizes)
    if (size.width == width && size.height == height) return &size;
  return nullptr;
}

}  // namespace darwinop
