// RGB to HSV in the integer arithmetic of the robot's original colour filter.
#pragma once

#include <algorithm>
#include <cstdint>

namespace darwinop::vision {

/// Hue of grey, including black and white.
inline constexpr int kNoHue = 0xFFFF;

struct Hsv {
  int hue = kNoHue;    // degrees, 0..359, or kNoHue
  int saturation = 0;  // percent, 0..100
  int value = 0;       // percent, 0..100; 0 for every grey, including white
  bool operator==(const Hsv&) const = default;
};

/// Every division truncates towards zero: 255 0 4 has hue 0, 255 0 5 has hue 359.
constexpr Hsv toHsv(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  const int r = red, g = green, b = blue;
  const int most = std::max({r, g, b}), least = std::min({r, g, b}), range = most - least;
  if (range == 0) return {};
  int hue = 0;
  if (most == r)
    hue = 60 * (g - b) / range;
  else if (most == g)
    hue = 120 + 60 * (b - r) / range;
  else
    hue = 240 + 60 * (r - g) / range;
  return {hue < 0 ? hue + 360 : hue, 255 * range / most * 100 / 255, most * 100 / 255};
}

}  // namespace darwinop::vision
