// Named poses of the robot.
#pragma once

#include <array>
#include <numbers>
#include <string_view>

#include "core/conversions.hpp"
#include "core/joints.hpp"

namespace darwinop::twin {

using Angles = std::array<double, kJoints>;  // rad

/// Start pose (kneeling), from the joint table.
inline Angles startAngles() {
  Angles angles{};
  for (std::size_t i = 0; i < kJoints; ++i) angles[i] = (kJointTable[i].start - kTickCentre) * kRadPerTick;
  return angles;
}

/// Upright on straight legs, arms beside the body, looking ahead.
inline Angles standingAngles() {
  Angles angles{};
  constexpr double kRight = std::numbers::pi / 2;
  // At zero the upper arms point 45 deg outward and the elbows are bent by 90 deg.
  angles[index(Joint::kArmUpperR)] = -0.6;
  angles[index(Joint::kArmUpperL)] = 0.6;
  angles[index(Joint::kArmLowerR)] = 0.4 - kRight;
  angles[index(Joint::kArmLowerL)] = kRight - 0.4;
  angles[index(Joint::kHead)] = 0.6;
  return angles;
}

}  // namespace darwinop::twin
