// A controller's settings of one motor, converted to the joint command of each step.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "core/commands.hpp"
#include "core/conversions.hpp"
#include "core/goals/speed_ramp.hpp"
#include "core/sensors.hpp"

namespace darwinop::goals {

/// Values are numbers, INFINITY included, never NaN.
class MotorControl {
 public:
  explicit MotorControl(Joint joint) : row_{&row(joint)} {}

  void setPosition(double rad);
  void setVelocity(double rad_per_s) { velocity_ = rad_per_s; }
  /// 0 or less: no ramp.
  void setAcceleration(double rad_per_s2);
  void setAvailableTorque(double newton_meter);
  void setTorque(double newton_meter);
  void setPGain(double kp) { p_gain_ = kp; }
  /// The next command with an acceleration starts at rest.
  void restartRamp() { ramp_ = {}; }

  /// Command for the next `dt_s` seconds; `seen`: newest sensor values of the joint. `usual_gain`: P gain without
  /// setPGain(); NaN: not known.
  [[nodiscard]] JointCommand command(const JointSensors& seen, double usual_gain, double dt_s);

  [[nodiscard]] const JointRow& joint() const { return *row_; }
  [[nodiscard]] std::optional<double> position() const { return position_; }
  [[nodiscard]] double velocity() const { return velocity_.value_or(kMaxVelocity); }
  [[nodiscard]] double acceleration() const { return acceleration_; }
  [[nodiscard]] double availableTorque() const { return available_torque_.value_or(kMaxTorqueNm); }
  [[nodiscard]] double low() const { return radFromTicks(row_->low).value; }
  [[nodiscard]] double high() const { return radFromTicks(row_->high).value; }

 private:
  [[nodiscard]] std::optional<double> goal(const JointSensors& seen);
  [[nodiscard]] Rad withinPull(double goal, const JointSensors& seen, double usual_gain) const;
  [[nodiscard]] double torqueLimit() const;
  [[nodiscard]] bool passesZero() const;
  void addTorque(JointCommand& command) const;

  const JointRow* row_;
  std::optional<double> position_, velocity_, available_torque_, p_gain_;
  std::optional<double> torque_;  // set: pushes towards an end of the range
  double zero_for_s_ = 0;         // torque control with a torque of 0
  std::optional<double> held_;    // velocity control at speed 0
  bool torque_touched_ = false;   // from then on every command sets torque on or off
  double acceleration_ = -1;
  SpeedRamp ramp_;
};

}  // namespace darwinop::goals
