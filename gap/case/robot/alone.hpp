// Parts of a recording of the robot in which one joint moves alone.
#pragma once

#include <array>
#include <vector>

#include "core/joints.hpp"
#include "experiments/logs/log.hpp"

namespace darwinop::gap {

/// A part of a recording in which one joint is commanded to move, or limp, while all others hold their goals.
struct AlonePart {
  double from_s, to_s;                     // of the recording's own clock
  double goal_before_rad;                  // of the joint in the row before; NaN: limp, or the recording begins here
  std::array<double, kJoints> angles_rad;  // mean position of each joint; NaN: it does not answer
  std::array<double, 3> accel_m_s2;        // mean; right, forward, up; NaN: no board
  double supply_v;                         // mean of the board, or of the joint; NaN: neither is known
};

/// One for each P gain and speed limit, in the order of time; those of 2 s or more. Throws std::runtime_error for a log
/// that is not a recording of the runtime.
std::vector<AlonePart> aloneParts(const logs::Log& recording, Joint joint);

}  // namespace darwinop::gap
