// What each target's file has for one joint. The texts write these numbers and the simulators of semantics.hpp move by
// them: what is measured is what was written.
#pragma once

#include "gap/export/numbers.hpp"

namespace darwinop::gap {

/// RotationalMotor, HingeJointParameters, PositionSensor, HingeJointWithBacklash.
struct WebotsFields {
  double max_velocity = 0, acceleration = -1;  // -1: no limit
  double max_torque = 0;
  double p = 0, i = 0, d = 0;                        // controlPID
  double damping_constant = 0, static_friction = 0;  // jointParameters
  double gap = 0;                                    // 0: no play
  double resolution = -1;                            // of the sensor; -1: none
};

/// One hinge, one more for play or flex behind it (flex, where it has both), and two actuators: the controller, and the
/// back EMF, which no forcerange may cut.
struct MujocoFields {
  double timestep = 0.002;
  double armature = 0, damping = 0, frictionloss = 0;
  double gain = 0, kp = 0, kd = 0, force = 0;  // clip(gain * goal - kp q - kd w, +-force)
  double back_emf = 0;                         // and - back_emf w
  double play = 0;                             // range of the second hinge; 0: none
  double stiffness = 0, flex_damping = 0;      // of the second hinge; 0: none
  double sensor_noise = 0;

  [[nodiscard]] bool twoHinges() const { return play > 0 || stiffness > 0; }
  /// solref of friction and of the stops: the stiffest that MuJoCo takes at this step.
  [[nodiscard]] double hardTime() const { return 2 * timestep; }
};
inline constexpr double kFrictionImpedance = 0.9999, kStopImpedance = 0.99;  // solimp: how firmly they hold

/// dynamics and limit.
struct UrdfFields {
  double damping = 0, friction = 0;
  double effort = 0, velocity = 0;
};

WebotsFields webotsFields(const ServoNumbers& servo);
/// `load_kgm2`: without armature; sets how firmly a motor of law speed_p may hold its speed.
MujocoFields mujocoFields(const ServoNumbers& servo, double load_kgm2, double timestep_s);
UrdfFields urdfFields(const ServoNumbers& servo);

}  // namespace darwinop::gap
