// Equation of motion of a limb on a clamped trunk: mass matrix and bias torques, by recursion over its links.
#pragma once

#include "gap/plant/body/limb.hpp"

namespace darwinop::gap {

/// Joints of the longest limb. Matrices of this size stay on the stack.
inline constexpr int kLimbJoints = 6;
using LimbVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kLimbJoints, 1>;
using LimbMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kLimbJoints, kLimbJoints>;

struct LimbDynamics {
  LimbMatrix mass;  // kg m2, without the servos' armatures
  LimbVector bias;  // N m: what the joints need at acceleration 0 against gravity and velocity products

  /// `angles`: true angles of the joints. `gravity`: m/s2, in the trunk's frame.
  LimbDynamics(const Limb& limb, const LimbVector& angles, const LimbVector& velocities,
               const Eigen::Vector3d& gravity);
};

}  // namespace darwinop::gap
