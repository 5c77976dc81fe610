// Balance feedback: what the gyroscope sees turns knees, ankles and hips against the fall.
#pragma once

#include "managers/gait/goals.hpp"

namespace darwinop::gait {

/// Gyro counts from the centre. Falling forwards: pitch < 0. Rolling to the left: roll > 0. NaN: not known.
struct Tilt {
  double roll, pitch;
};

/// Without a known tilt, nothing is added.
void addBalance(Goals& goals, const Tilt& tilt, const Parameters& parameters);

}  // namespace darwinop::gait
