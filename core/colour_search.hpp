// Colour search in camera pictures: thresholds and allowed coverage.
#pragma once

namespace darwinop {

/// Defaults of the robot's original software, for its red ball.
struct ColourThresholds {
  int hue = 356;            // degrees, 0..360
  int hue_tolerance = 15;   // degrees, 0..180
  int min_saturation = 50;  // percent, 0..100, exclusive. Below 0: any, including grey
  int min_value = 10;       // percent, 0..100, exclusive. Below 0: any, including grey
  bool operator==(const ColourThresholds&) const = default;
};

/// Allowed percentage of detected pixels: min < percentage <= max.
struct PercentLimits {
  double min = 0.07;
  double max = 30.0;
  bool operator==(const PercentLimits&) const = default;
};

struct Pixel {
  int x, y;  // right and down from the top left corner
  bool operator==(const Pixel&) const = default;
};

}  // namespace darwinop
