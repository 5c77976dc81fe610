// Slow move of all joints from the present goals to the first pose of a motion; at rest at both ends.
#pragma once

#include "core/goals/gentle_move.hpp"
#include "core/joints.hpp"
#include "core/servo_limits.hpp"

namespace darwinop::goals {

class LeadIn : public GentleMove<kJoints> {
 public:
  /// Peak speed of the joint with the longest distance.
  static constexpr double kSpeed = kGentleSpeed;

  LeadIn() = default;  // done
  LeadIn(const Pose& from, const Pose& to) : GentleMove{from, to, durationMs(longestDistance(from, to))} {}

  using GentleMove::durationMs;
  /// For the longest distance of a joint, rad.
  static double durationMs(double distance) { return kPeakPerMean * distance / kSpeed * 1000; }
};

}  // namespace darwinop::goals
