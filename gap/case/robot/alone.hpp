// Parts of a recording of the robot in which one joint moves alone.
#pragma once

#include <array>
#include <vector>

#include "core/joints.hpp"
#include "experiments/logs/log.hpp"

namespace darwinop::gap {

/// A part of a recording in which one joint is asked to move, or is let go, while all others are asked to stand still.
struct AlonePart {
  double from_s, to_s;                     // of the recording's own clock
  std::array<double, kJoints> angles_rad;  // mean of what the joints said
  std::array<double, 3> accel_m_s2;        // mean; right, forward, up
  double supply_v;                         // of the board, mean
};

/// One for each P gain and speed limit, in the order of time; those of 2 s or more. Throws std::runtime_error for a log
/// that is no recording of the runtime.
std::vector<AlonePart> aloneParts(const logs::Log& recording, Joint joint);

}  // namespace darwinop::gap
