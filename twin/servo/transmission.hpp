// Transmission with backlash or elasticity: gear side and arm as two bodies.
//
//   rotor and gears (armature) --[ free play ]-- horn --[ spring and damper ]-- arm
//
// The encoder sits on the horn. With play alone the horn moves with the arm, so the encoder measures the arm. With a
// spring the horn is on the motor side, so the encoder does not measure the deflection.
#pragma once

#include "twin/servo/servo.hpp"
#include "twin/servo/shaft.hpp"

namespace darwinop::twin {

/// State of the arm during one mechanical step.
struct ArmMotion {
  double position_rad = 0, velocity_rad_s = 0;  // at the start of the step
  double inertia_kgm2 = 0;                      // about the joint, without the servo's armature
  double outside_nm = 0;                        // all torques on the arm except the transmission's: gravity, contacts
};

/// Transmission of one joint. step() allocates nothing.
class Transmission {
 public:
  /// Initial state: gears and arm at the same position and velocity. `rotor_kgm2`: armature including effects.
  void reset(double position_rad, double velocity_rad_s, double rotor_kgm2) noexcept;

  /// Initial state at rest: the encoder reads `encoder_rad`, and gears and arm are as far apart as it takes to exert
  /// `torque_nm` on the arm. Returns the position of the arm.
  double rest(const Signals& s, double encoder_rad, double torque_nm, double rotor_kgm2) noexcept;

  /// Integrates the gear side over one mechanical step, in sub-steps if the spring requires them. The arm's motion
  /// within the step is predicted from its inertia and the external torque. Returns the mean torque on the arm.
  double step(Servo& servo, const ArmMotion& arm, double dt_s) noexcept;

  /// Encoder position, for Servo::firmware().
  [[nodiscard]] double encoderRad(const Signals& s, double arm_rad) const noexcept;

  /// Inertia that an arm of `arm_kgm2` counts with: at least 1 % of the rotor's.
  [[nodiscard]] double armInertia(double arm_kgm2) const noexcept;

  [[nodiscard]] double gearVelocity() const noexcept { return velocity_; }
  /// Of rotor and spring, J.
  [[nodiscard]] double energy_j(const Signals& s, double arm_rad) const noexcept;

  /// Number of sub-steps of `dt_s` that resolve the fastest oscillation between rotor and arm.
  [[nodiscard]] int stepsFor(const Signals& s, double arm_kgm2, double dt_s) const noexcept;

 private:
  struct Contact {
    double bend_rad;
    double torque_nm;  // on the arm
  };
  [[nodiscard]] Contact contact(const Signals& s, double gear, double gear_speed, double arm,
                                double arm_speed) const noexcept;

  Shaft shaft_;
  double rotor_kgm2_ = 0, position_ = 0, velocity_ = 0;
};

}  // namespace darwinop::twin
