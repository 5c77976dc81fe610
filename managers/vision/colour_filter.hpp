// Which colours count as the ball's: the rule, pixel by pixel. colour_test.hpp decides the same without dividing.
#pragma once

#include "core/colour_search.hpp"
#include "managers/vision/hsv.hpp"

namespace darwinop::vision {

using Thresholds = ColourThresholds;

/// Hues between two bounds that do not belong to it; through 0 where low is above high.
struct HueArc {
  long long low, high;  // degrees

  constexpr explicit HueArc(const Thresholds& wanted)
      : low{static_cast<long long>(wanted.hue) - wanted.hue_tolerance},
        high{static_cast<long long>(wanted.hue) + wanted.hue_tolerance} {
    if (high > 360) high -= 360;  // 360 itself stays
    if (low < 0) low += 360;
  }

  [[nodiscard]] constexpr bool contains(int hue) const {
    return low <= high ? low < hue && hue < high : hue > low || hue < high;
  }
};

/// Grey's 0xFFFF is hue 15 here. It matters only where both minima are below 0, as grey's other numbers are 0.
constexpr bool matches(const Hsv& colour, const Thresholds& wanted) {
  const int hue = colour.hue > 360 ? colour.hue % 360 : colour.hue;
  return colour.saturation > wanted.min_saturation && colour.value > wanted.min_value && HueArc{wanted}.contains(hue);
}

}  // namespace darwinop::vision
