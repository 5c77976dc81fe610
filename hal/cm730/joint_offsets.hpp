// How far each servo's horn sits off its joint's zero: added on the way to the servo, taken off on the way back.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/conversions.hpp"
#include "core/joints.hpp"

namespace darwinop::cm730 {

/// In whole ticks, so that a position that was read and is given as a goal is the same tick again.
class JointOffsets {
 public:
  void set(Joint joint, Rad offset) noexcept {
    ticks_[index(joint)] = static_cast<std::int16_t>(std::nearbyint(offset.value / kRadPerTick));
  }
  [[nodiscard]] int ticks(Joint joint) const noexcept { return ticks_[index(joint)]; }

  /// What register 30 gets for a goal, before limits.
  [[nodiscard]] int servoTicks(Joint joint, Rad goal) const noexcept { return ticksFromRad(goal) + ticks(joint); }
  /// The joint's angle when register 36 says `servo_ticks`.
  [[nodiscard]] Rad jointAngle(Joint joint, int servo_ticks) const noexcept {
    return radFromTicks(servo_ticks - ticks(joint));
  }

  /// Angles of the joint table that the servo can be sent to without leaving the table's range itself.
  [[nodiscard]] Rad low(Joint joint) const noexcept {
    return radFromTicks(row(joint).low + std::max(0, -ticks(joint)));
  }
  [[nodiscard]] Rad high(Joint joint) const noexcept {
    return radFromTicks(row(joint).high - std::max(0, ticks(joint)));
  }

 private:
  std::array<std::int16_t, kJoints> ticks_{};
};

}  // namespace darwinop::cm730
