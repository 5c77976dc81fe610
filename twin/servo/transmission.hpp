// Gear side and arm of a joint that has play or bends: two bodies, and the gear train between them.
//
//   rotor and gears (armature) --[ free play ]-- horn --[ spring and damper ]-- arm
//
// The encoder sits on the horn. With play alone the horn is the arm: the encoder sees the arm move while the gears
// stand. With a spring the horn is on the motor's side of it: the encoder does not see the arm droop.
#pragma once

#include "twin/servo/servo.hpp"
#include "twin/servo/shaft.hpp"

namespace darwinop::twin {

/// What the gear train meets during one mechanical step.
struct ArmMotion {
  double position_rad = 0, velocity_rad_s = 0;  // at the beginning of the step
  double inertia_kgm2 = 0;                      // about the joint, without the servo's armature
  double outside_nm = 0;                        // all torques on the arm but the gear train's: gravity, contacts
};

/// One joint's gear train. step() allocates nothing.
class Transmission {
 public:
  /// Gears and arm move together from here, in the middle of the play. `rotor_kgm2`: armature and what effects add.
  void reset(double position_rad, double velocity_rad_s, double rotor_kgm2) noexcept;

  /// Moves the gear side by one mechanical step, in smaller steps where the spring asks for them; the arm's own motion
  /// within the step is foreseen from its inertia and the torque outside. Returns the mean torque on the arm.
  double step(Servo& servo, const ArmMotion& arm, double dt_s) noexcept;

  /// Goes into Servo::firmware().
  [[nodiscard]] double encoderRad(const Signals& s, double arm_rad) const noexcept;

  [[nodiscard]] double gearRad() const noexcept { return position_; }
  [[nodiscard]] double gearVelocity() const noexcept { return velocity_; }
  /// Of rotor and spring, J.
  [[nodiscard]] double energy_j(const Signals& s, double arm_rad) const noexcept;

  /// Steps that `dt_s` has to be cut into so that the fastest swing of rotor against arm is followed.
  [[nodiscard]] int stepsFor(const Signals& s, double arm_kgm2, double dt_s) const noexcept;

 private:
  struct Touch {
    double bend_rad;
    double torque_nm;  // on the arm
  };
  [[nodiscard]] Touch touch(const Signals& s, double gear, double gear_speed, double arm,
                            double arm_speed) const noexcept;

  Shaft shaft_;
  double rotor_kgm2_ = 0, position_ = 0, velocity_ = 0;
};

}  // namespace darwinop::twin
