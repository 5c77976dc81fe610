// A colour to be found in camera frames: its bounds, and how much of a frame it may cover.
#pragma once

namespace darwinop {

/// Defaults are those of the robot's own software, for its red ball.
struct ColourThresholds {
  int hue = 356;            // degrees, 0..360
  int hue_tolerance = 15;   // degrees, 0..180
  int min_saturation = 50;  // percent, 0..100; itself excluded. Less than 0: any, greys included
  int min_value = 10;       // percent, 0..100; itself excluded. Less than 0: any, greys included
  bool operator==(const ColourThresholds&) const = default;
};

/// Share of the frame that has the colour. `min` itself is too little, `max` itself is not too much.
struct PercentLimits {
  double min = 0.07;
  double max = 30.0;
  bool operator==(const PercentLimits&) const = default;
};

struct Pixel {
  int x, y;  // to the right and down, from the top left corner
  bool operator==(const Pixel&) const = default;
};

}  // namespace darwinop
