// Couples 20 servo models to 20 MuJoCo hinges: torque, damping, dry friction, speed-controlled motors, transmissions.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "twin/body/mujoco_model.hpp"
#include "twin/servo/servo.hpp"
#include "twin/servo/transmission.hpp"

namespace darwinop::twin {

/// Dry friction is a solver constraint, solved together with all joints and contacts. A speed-controlled motor (law
/// speed_p) is another friction constraint, towards its target speed. With an elastic transmission the rotor is not
/// part of the MuJoCo body: the joint receives the transmission torque.
class JointTorques {
 public:
  /// Writes rotor inertias and load changes into the model.
  JointTorques(mjModel& m, const BodyMap& map, const std::vector<Servo>& servos, bool hold_until_driven);

  /// Initial state: all joints at rest at the angles in `d`.
  void reset(const mjData& d, const BodyMap& map) noexcept;
  /// Encoder position of joint i.
  [[nodiscard]] double encoderRad(const Servo& servo, std::size_t i, double arm_rad) const noexcept;
  /// One physics step.
  void step(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;

 private:
  struct Bristle {
    double creep_rad_s, bend_rad;
  };
  void act(mjModel& m, mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;
  void setFrictionReferences(mjData& d, const BodyMap& map) noexcept;
  double bend(std::size_t i, double position, const Bristle& full) noexcept;
  void readSolverForces(const mjModel& m, const mjData& d, const BodyMap& map, std::vector<Servo>& servos) noexcept;

  std::array<bool, kJoints> soft_{};
  std::array<double, kJoints> rotor_kgm2_{};
  std::array<Transmission, kJoints> gears_{};
  std::array<Actuation, kJoints> acts_{};
  std::array<double, kJoints> outside_nm_{};  // external torque in the previous step, without the joint's own inertia
  bool hold_;                                 // joints keep their angle until their torque is first enabled
  std::array<bool, kJoints> held_{};          // not yet enabled
  std::array<double, kJoints> velocity_{};    // before the step
  std::array<double, kJoints> rest_rad_{};    // anchor of the bristle
};

}  // namespace darwinop::twin
