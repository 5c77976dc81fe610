// Poses from which motions start.
#pragma once

#include "gap/benchmark/body/motions.hpp"

namespace darwinop::gap {

/// rad; right joints of a kind, the left ones mirrored.
struct MirroredPose {
  double shoulder, arm_upper, arm_lower, pelvis_yaw, pelvis, leg_upper, leg_lower, ankle, foot, neck, head;
};
inline constexpr MirroredPose kHanging{-0.2, 0.15, -0.2, -0.2, 0.15, -0.55, 0.8, 0.1, 0.1, 0, 0.3};
inline constexpr MirroredPose kStanding{-0.84, -0.31, 0.51, 0, 0, -0.63, 0.93, 0.52, 0.01, 0, 0.2};

Goals goalsOf(const MirroredPose& pose);

inline double& at(Goals& goals, Joint joint) {
  return goals[static_cast<std::size_t>(joint)];
}

/// 0 to 1 within `over_s`, smooth at both ends.
double ramp(double time_s, double over_s);

}  // namespace darwinop::gap
