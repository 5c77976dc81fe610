// Phases of a gait period: times at which each foot lifts and lands, ms.
#pragma once

#include "managers/gait/parameters.hpp"

namespace darwinop::gait {

/// Time per engine call, ms.
inline constexpr double kTickMs = 8;

struct Timing {
  explicit constexpr Timing(const Parameters& p)
      : period{p.period_time},
        swing_share{1 - p.dsp_ratio},
        left_up{(1 - swing_share) * period / 4},
        left_down{(1 + swing_share) * period / 4},
        right_up{(3 - swing_share) * period / 4},
        right_down{(3 + swing_share) * period / 4} {}

  double period, swing_share;
  double left_up, left_down, right_up, right_down;  // the left foot swings first

  [[nodiscard]] constexpr double middleOfLeft() const { return (left_up + left_down) / 2; }
  [[nodiscard]] constexpr double middle() const { return (left_down + right_up) / 2; }
  [[nodiscard]] constexpr double middleOfRight() const { return (right_up + right_down) / 2; }
  /// A foot moves from rear to front in half of this; it lifts and lands within `lift()`.
  [[nodiscard]] constexpr double move() const { return swing_share * period; }
  [[nodiscard]] constexpr double lift() const { return swing_share * period / 2; }
};

/// True in the call closest to `moment`.
constexpr bool isAt(double time, double moment) {
  return moment - kTickMs / 2 <= time && time < moment + kTickMs / 2;
}

}  // namespace darwinop::gait
