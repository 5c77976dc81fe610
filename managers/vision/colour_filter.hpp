// Reference definition of the colour filter. colour_test.hpp is equivalent without divisions.
#pragma once

#include "core/colour_search.hpp"
#include "managers/vision/hsv.hpp"

namespace darwinop::vision {

using Thresholds = ColourThresholds;

/// Open interval of hues; passes through 0 if low > high.
struct HueArc {
  long long low, high;  // degrees

  constexpr explicit HueArc(const Thresholds& wanted)
      : low{static_cast<long long>(wanted.hue) - wanted.hue_tolerance},
        high{static_cast<long long>(wanted.hue) + wanted.hue_tolerance} {
    if (high > 360) high -= 360;  // 360 is kept
    if (low < 0) low += 360;
  }

  [[nodiscard]] constexpr bool contains(int hue) const {
    return low <= high ? low < hue && hue < high : hue > low || hue < high;
  }
};

/// The hue 0xFFFF of grey counts as 15. Relevant only if both minima are below 0, because saturation and value of grey
/// are 0.
constexpr bool matches(const Hsv& colour, const Thresholds& wanted) {
  const int hue = colour.hue > 360 ? colour.hue % 360 : colour.hue;
  return colour.saturation > wanted.min_saturation && colour.value > wanted.min_value && HueArc{wanted}.contains(hue);
}

}  // namespace darwinop::vision
