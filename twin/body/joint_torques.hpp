// Twenty servos on twenty hinges for one step: torque, damping, dry friction, motors that follow a speed, soft gears.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "twin/body/mujoco_model.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::twin {

/// Dry friction is a constraint of the solver: it brings a joint to rest with what that takes, up to its limit, while
/// all other joints and contacts do the same. A motor that follows a speed is one more friction, towards that speed.
/// With a soft gear the rotor is no part of MuJoCo's body: the joint gets the torque of the gear train.
class JointTorques {
 public:
  /// Puts the servos' rotors and loads into the model.
  JointTorques(mjModel& m, const BodyMap& map, const std::vector<Servo>& servos, bool hold_until_driven);

  /// Everything rests, at these angles.
  void reset(const mjData& d, const BodyMap& map) noexcept;
  /// The angle that the encoder of joint i sees.
  [[nodiscard]] double encoderRad(const Servo& servo, std::size_t i, double arm_rad) const noexcept;
  /// One step of the physics.
  void step(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;

 private:
  struct Bristle {
    double creep_rad_s, bend_rad;
  };
  void act(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;
  void aimFrictions(mjData& d, const BodyMap& map) noexcept;
  double bend(std::size_t i, double position, const Bristle& full) noexcept;
  void takeNote(const mjModel& m, const mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;

  std::array<bool, kJoints> soft_{};
  std::array<double, kJoints> rotor_kgm2_{};
  std::array<Transmission, kJoints> gears_{};
  std::array<Actuation, kJoints> acts_{};
  std::array<double, kJoints> outside_nm_{};  // of the step before: what others did to the joint, its inertia apart
  bool hold_;                               // a joint keeps its angle until its servo is switched on for the first time
  std::array<bool, kJoints> held_{};        // it still does
  std::array<double, kJoints> velocity_{};  // before the step
  std::array<double, kJoints> rest_rad_{};  // where the joint came to rest, within the bend of a bristle
};

}  // namespace darwinop::twin
