// Balance feedback: corrects knees, ankles and hips in proportion to the gyroscope.
#pragma once

#include "managers/gait/goals.hpp"

namespace darwinop::gait {

/// Gyroscope counts relative to the centre. Falling forwards: pitch < 0. Rolling to the left: roll > 0. NaN: unknown.
struct Tilt {
  double roll, pitch;
};

/// Adds nothing if the tilt is unknown.
void addBalance(Goals& goals, const Tilt& tilt, const Parameters& parameters);

}  // namespace darwinop::gait
