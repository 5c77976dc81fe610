// Horn offsets: added to goals, subtracted from positions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/conversions.hpp"
#include "core/joints.hpp"

namespace darwinop::cm730 {

/// In whole ticks, so that a position that is commanded as a goal maps to the same tick.
class JointOffsets {
 public:
  void set(Joint joint, Rad offset) noexcept {
    ticks_[index(joint)] = static_cast<std::int16_t>(std::nearbyint(offset.value / kRadPerTick));
  }
  [[nodiscard]] int ticks(Joint joint) const noexcept { return ticks_[index(joint)]; }

  /// Goal register value for an angle, before limits.
  [[nodiscard]] int servoTicks(Joint joint, Rad goal) const noexcept { return ticksFromRad(goal) + ticks(joint); }
  /// Joint angle for position register value `servo_ticks`.
  [[nodiscard]] Rad jointAngle(Joint joint, int servo_ticks) const noexcept {
    return radFromTicks(servo_ticks - ticks(joint));
  }

  /// Joint table ranges that the servo can reach without leaving the table's range itself.
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
