// A body without physics library: every joint is a motor with its own inertia, nothing pulls at it.
#pragma once

#include "hal/body.hpp"

namespace darwinop::hil {

/// Second-order motion of each joint: a DC motor behind a P controller, its set point moving at the speed limit.
/// Starts in the start pose, upright and at rest. Joints differ slightly in inertia and settle 0, +1 or -1 tick
/// beside the goal (index modulo 3), so that crossed wires show.
class PlainBody : public Body {
 public:
  PlainBody();
  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override { return state_; }

  /// Puts a joint somewhere, at rest.
  void place(Joint joint, double position_rad) noexcept;
  /// Presses the board's buttons: 1 MODE, 2 START.
  void press(std::uint8_t buttons) noexcept { state_.buttons = buttons; }

 protected:
  /// For bodies with more forces than this one.
  [[nodiscard]] JointMotion& motion(Joint joint) noexcept { return state_.joint[index(joint)]; }

 private:
  BodyState state_;
  std::array<double, kJoints> set_point_rad_{};
};

}  // namespace darwinop::hil
