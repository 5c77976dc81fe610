// A colour as hue, saturation and value, in the whole numbers that the robot's colour filter has always used.
#pragma once

#include <algorithm>
#include <cstdint>

namespace darwinop::vision {

/// Grey has no hue; black and white are greys, too.
inline constexpr int kNoHue = 0xFFFF;

struct Hsv {
  int hue = kNoHue;    // degrees, 0..359, or kNoHue
  int saturation = 0;  // percent, 0..100
  int value = 0;       // percent, 0..100; 0 for every grey, white too
  bool operator==(const Hsv&) const = default;
};

/// Every division cuts off what is behind the point, also below zero: 255 0 4 is still hue 0, and 255 0 5 is 359.
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
