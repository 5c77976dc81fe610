// Body without physics library: independent joints, each a motor with inertia; no gravity.
#pragma once

#include "hal/body.hpp"

namespace darwinop::hil {

/// Second-order joint dynamics: DC motor with P controller, set point limited in speed. Initially in the start pose,
/// upright and at rest. Joints differ slightly in inertia, and settle 0, +1 or -1 tick beside the goal (index modulo
/// 3), so that swapped joints are detectable.
class PlainBody : public Body {
 public:
  PlainBody();
  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override { return state_; }

  /// Sets a joint's position, at rest.
  void place(Joint joint, double position_rad) noexcept;
  /// Presses the board's buttons: 1 MODE, 2 START.
  void press(std::uint8_t buttons) noexcept { state_.buttons = buttons; }

 protected:
  /// For derived bodies with additional forces.
  [[nodiscard]] JointMotion& motion(Joint joint) noexcept { return state_.joint[index(joint)]; }

 private:
  BodyState state_;
  std::array<double, kJoints> set_point_rad_{};
};

}  // namespace darwinop::hil
