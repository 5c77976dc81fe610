// From where the joints are to where a recorded movement begins: all together, at rest at both ends, never fast.
#pragma once

#include "core/gentle_move.hpp"
#include "core/joints.hpp"

namespace darwinop {

class LeadIn : public GentleMove<kJoints> {
 public:
  /// rad/s, 11.4 rpm: what the goal of the joint with the longest way takes in the middle. The runtime brings a robot
  /// to its start pose as fast as that, unless config.ini says otherwise (gentle_speed, safety/config.hpp).
  static constexpr double kSpeed = 1.194;

  LeadIn() = default;  // done
  LeadIn(const Pose& from, const Pose& to) : GentleMove{from, to, durationMs(longestWay(from, to))} {}

  using GentleMove::durationMs;
  /// For the longest way of a joint.
  static double durationMs(double way) { return kSteepest * way / kSpeed * 1000; }
};

}  // namespace darwinop
