// Model of one servo: command, encoder, controller, motor, temperature. The load on the horn is simulated elsewhere: a
// pendulum (twin/bench) or the robot body (twin/body).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "hal/body.hpp"
#include "twin/servo/effect.hpp"
#include "twin/servo/heat.hpp"
#include "twin/servo/profile.hpp"
#include "twin/servo/speed_meter.hpp"

namespace darwinop::twin {

/// Torque of the motor side during one mechanical step: torque - damping * velocity, and dry friction of up to
/// `friction_nm` against motion.
struct Actuation {
  double torque_nm = 0;
  double damping_nms_rad = 0;  // back EMF and viscous friction
  double friction_nm = 0;
  // Law speed_p: target velocity and the torque available to reach it; torque_nm and back EMF damping are then 0.
  bool follows_speed = false;
  double speed_rad_s = 0, speed_torque_nm = 0;
};

/// Not thread-safe; allocates only on construction.
class Servo {
 public:
  /// Throws std::runtime_error if the effects make the armature negative.
  Servo(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects);

  /// Initial state: at rest at `position_rad`, goal equal to it, torque off, history cleared.
  void reset(double position_rad, double session_time_s = 0) { reset(position_rad, position_rad, session_time_s); }
  /// The same with another goal, at which profile and delays have arrived.
  void reset(double position_rad, double goal_rad, double session_time_s);

  /// One firmware period: reads command and encoder, sets the duty. `position_rad` at the encoder; with an elastic
  /// transmission see Transmission::encoderRad().
  void firmware(const ServoDrive& drive, double position_rad, double velocity_rad_s) noexcept;

  /// Sets the integral so that the last period's duty is `duty`, as after a hold of unknown length. No effect without
  /// an I gain, with torque off, or under law speed_p.
  void startIntegralFrom(double duty) noexcept;

  /// Torques on the motor side in this state, within the period. `external_nm`: torque of gravity and contacts on the
  /// arm, without its inertia, from the previous step.
  Actuation actuate(double position_rad, double velocity_rad_s, double external_nm) noexcept;
  /// Law speed_p: stores the torque that the motor used in the step after actuate().
  void noteMotorTorque(double torque_nm) noexcept;

  /// Register values: encoder position, velocity and load as the servo computes them.
  [[nodiscard]] JointMotion report() const noexcept;

  [[nodiscard]] const Signals& signals() const noexcept { return signals_; }
  [[nodiscard]] const ServoParameters& parameters() const noexcept { return parameters_; }
  /// Load changes of all effects.
  [[nodiscard]] const LoadChange& load() const noexcept { return load_; }
  /// True with backlash or joint elasticity: gear side and horn must be integrated separately (transmission.hpp).
  [[nodiscard]] bool softGear() const noexcept;

 private:
  void followGoal(double dt_s) noexcept;
  void control(const ServoDrive& drive, double dt_s) noexcept;
  void applyVoltageLaw(double dt_s) noexcept;
  void applySpeedLaw(double dt_s) noexcept;
  void updateLoad() noexcept;
  [[nodiscard]] double motorTorque(double velocity_rad_s) const noexcept;

  ServoParameters parameters_;
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<Effect*> command_, sensor_, controller_, motor_, mechanics_;
  LoadChange load_;
  Signals signals_;

  double ticks_per_rad_, rad_per_tick_;
  double load_share_;  // low-pass coefficient of the torque feedback, per period
  // At this period's duty and voltage: stall torque, and its reduction per speed by the back EMF.
  double stall_torque_nm_ = 0, braking_nms_rad_ = 0;
  SpeedMeter speed_meter_;
  Profile profile_;
  OverloadGuard overload_;
  double integral_ = 0, last_error_ = 0;
  double followed_nm_ = 0;  // law speed_p: torque in the last step
  double reported_load_ = 0;
  bool was_on_ = false;
};

}  // namespace darwinop::twin
