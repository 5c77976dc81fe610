// From where the joints are to where a recorded movement begins: all together, at rest at both ends, never fast.
#pragma once

#include "core/gentle_move.hpp"
#include "core/joints.hpp"
#include "core/servo_limits.hpp"

namespace darwinop {

class LeadIn : public GentleMove<kJoints> {
 public:
  /// What the goal of the joint with the longest way takes in the middle.
  static constexpr double kSpeed = kGentleSpeed;

  LeadIn() = default;  // done
  LeadIn(const Pose& from, const Pose& to) : GentleMove{from, to, durationMs(longestWay(from, to))} {}

  using GentleMove::durationMs;
  /// For the longest way of a joint.
  static double durationMs(double way) { return kSteepest * way / kSpeed * 1000; }
};

}  // namespace darwinop
