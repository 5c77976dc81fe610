// One servo as its registers and its horn see it: command, encoder, controller, motor, heat. What the horn carries is
// somebody else's: a pendulum (twin/bench) or a whole body (twin/body).
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

/// What the motor side puts on its shaft during one mechanical step: torque - damping * velocity, and dry friction
/// that takes up to `friction_nm` to bring the joint to rest and keep it there.
struct Actuation {
  double torque_nm = 0;
  double damping_nms_rad = 0;  // back EMF and viscous friction
  double friction_nm = 0;
  // Law speed_p: the motor wants this velocity and has this torque to reach it; then torque and the back EMF are 0.
  bool follows_speed = false;
  double speed_rad_s = 0, speed_torque_nm = 0;
};

/// Not thread-safe; allocates only on construction.
class Servo {
 public:
  /// Throws std::runtime_error when the effects leave it less than no inertia.
  Servo(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects);

  /// At rest here, its goal where it stands, torque off, all history forgotten.
  void reset(double position_rad, double session_time_s = 0);

  /// One firmware period: takes the command, reads the encoder, sets the duty. The caller counts the periods. Position
  /// is the encoder's; with a soft gear Transmission::encoderRad() tells it.
  void firmware(const ServoDrive& drive, double position_rad, double velocity_rad_s) noexcept;

  /// At a state of the motor side, within the period: what acts on it. `external_nm`: torque on the arm from outside,
  /// gravity and contacts, without its own inertia; as known from the step before.
  Actuation actuate(double position_rad, double velocity_rad_s, double external_nm) noexcept;
  /// Law speed_p: the torque that the motor took to reach its speed in the step that actuate() was for.
  void noteMotorTorque(double torque_nm) noexcept;

  /// As the registers will tell: position of the encoder, velocity and load as the servo makes them.
  [[nodiscard]] JointMotion report() const noexcept;

  [[nodiscard]] const Signals& signals() const noexcept { return signals_; }
  [[nodiscard]] const ServoParameters& parameters() const noexcept { return parameters_; }
  /// What the effects change of the load.
  [[nodiscard]] const LoadChange& load() const noexcept { return load_; }
  /// True when gear side and horn move apart: somebody must integrate both (transmission.hpp).
  [[nodiscard]] bool softGear() const noexcept;

 private:
  void followGoal(double dt_s) noexcept;
  void control(const ServoDrive& drive, double dt_s) noexcept;
  void pushByError(double dt_s) noexcept;
  void turnByError(double dt_s) noexcept;
  void showLoad() noexcept;
  [[nodiscard]] double motorTorque(double velocity_rad_s) const noexcept;

  ServoParameters parameters_;
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<Effect*> command_, sensor_, controller_, motor_, mechanics_;
  LoadChange load_;
  Signals signals_;

  double ticks_per_rad_, rad_per_tick_;
  double load_share_;  // of what is new in the torque feedback, a period
  // Of this period's duty and voltage: torque at rest, and what the back EMF takes of it per speed.
  double stalled_nm_ = 0, braking_nms_rad_ = 0;
  SpeedMeter speed_meter_;
  Profile profile_;
  OverloadGuard overload_;
  double integral_ = 0, last_error_ = 0;
  double followed_nm_ = 0;  // law speed_p: the last torque
  double shown_load_ = 0;
  bool was_on_ = false;
};

}  // namespace darwinop::twin
