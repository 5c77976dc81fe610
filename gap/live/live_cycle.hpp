// One cycle of the robot, as an observer of the runtime gets it.
#pragma once

#include <array>

#include "core/sensors.hpp"

namespace darwinop::gap::live {

struct LiveCycle {
  Sensors sensors;  // what was not received is NaN or old
  /// Kp that the controller asks for; NaN: not known, as over the network. The servo then counts as unchanged since its
  /// power-up.
  std::array<double, kJoints> p_gain{};
};

}  // namespace darwinop::gap::live
