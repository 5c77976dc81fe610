// A servo motor, one of 20: "ShoulderR" ... "Head".
#ifndef MOTOR_HPP
#define MOTOR_HPP

#include <math.h>

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace darwinop {
namespace goals {
class MotorControl;
}
}  // namespace darwinop

namespace webots {

class Brake;
class PositionSensor;

///     motor->setPosition(0.5);         // position control: goal in rad
///     motor->setVelocity(1.0);         // at 1 rad/s at most
///     motor->setPosition(INFINITY);    // velocity control: until the joint's limit
///     motor->setVelocity(-0.5);
///     motor->setAvailableTorque(0);    // limp
///
/// A setter takes effect at the next Robot::step(). Angles in rad, positive as the servo counts up; speeds in rad/s;
/// torques in N m. Numbers out of range are limited by the safety layer, which counts it; NaN is ignored with a
/// warning, and the value before stays in force. The safety layer also limits how fast a goal may move.
class Motor : public Device {
 public:
  /// Kind of motor; all are ROTATIONAL.
  enum Type { ROTATIONAL = 0, LINEAR = 1 };

  /// The robot's device of this name, for Robot::createMotor() and a class of your own; see Device.
  explicit Motor(const std::string& name);
  virtual ~Motor();

  /// Goal in rad, clamped to the range of the joint. INFINITY or -INFINITY selects velocity control, see setVelocity().
  /// Ends setTorque(). The joint approaches the goal no faster than setVelocity() and the safety layer allow.
  /// 2013: a goal beyond 0 to 4095 counts was ignored without a message; rounding was off by up to one count.
  virtual void setPosition(double position);
  /// The goal given last in rad, not clamped; before the first one, the goal that the robot holds.
  /// 2013: in encoder counts.
  double getTargetPosition() const;
  /// Maximum speed towards the goal in rad/s, 0.012 to 12.26 (default 12.26); the sign is ignored, 0 is the slowest
  /// speed of the servo. In velocity control the sign is the direction (default: upwards at 12.26 rad/s); the joint
  /// moves until its limit, and 0 holds it. Simulator: 0 stops the motor in both modes.
  virtual void setVelocity(double velocity);
  /// Acceleration in rad/s2: the speed limit rises with this slope up to setVelocity() and falls in time before the
  /// goal; computed once per step. 0 or less (default -1): no ramp. 2013: rose above setVelocity() and never fell.
  virtual void setAcceleration(double acceleration);
  /// Torque limit in N m, 0 to 2.5 (default 2.5). 0 or less: torque off, the joint is limp until a positive value.
  /// A limit that changes in every step reaches the servos in one cycle of 8 while one of them works at its limit.
  virtual void setAvailableTorque(double torque);
  /// Same as setAvailableTorque(); N m.
  virtual void setAvailableForce(double force);
  /// Pushes against an end of the range with this torque in N m, -2.5 to 2.5, **positive towards getMinPosition()**, as
  /// in 2013. 0: limp until setPosition() or another torque; less than 0.1 s of it only stops pushing. setPosition()
  /// ends it. Simulator: positive towards greater angles. 2013: 0 was limp for one step only.
  virtual void setTorque(double torque);
  /// Same as setTorque(); N m.
  virtual void setForce(double force);
  /// `p` is the proportional gain Kp of the servo, 0 to 31.75 in steps of 0.125, 4 by default; below 3 it logs a
  /// warning, since the joint may not reach its goal; a negative p is ignored. i and d have no effect. Simulator:
  /// default 10, and another control law (velocity proportional to the error).
  virtual void setControlPID(double p, double i, double d);

  /// Speed limit set last, rad/s, with its sign; not the measured speed, which the API does not have.
  double getVelocity() const;
  /// 12.26 rad/s. The servo's speed register ends at 12.21 rad/s. 2013: not available, as getMaxTorque() and its
  /// siblings.
  double getMaxVelocity() const;
  /// Acceleration set last, rad/s2; -1: none.
  double getAcceleration() const;
  /// Torque limit set last, 0 to 2.5 N m.
  double getAvailableTorque() const;
  /// Same as getAvailableTorque(); N m.
  double getAvailableForce() const;
  /// 2.5 N m, the stall torque of the MX-28 at 12 V.
  double getMaxTorque() const;
  /// Same as getMaxTorque(); N m.
  double getMaxForce() const;
  /// 1, no unit: motors are not coupled.
  double getMultiplier() const;
  /// Lower end of the joint's mechanical range in rad. Limits of config.ini or of the servo may be narrower.
  /// 2013: 0.125 % wider.
  double getMinPosition() const;
  /// Upper end of the joint's mechanical range in rad. 2013: ShoulderL ended at 1.61 rad instead of 2.85 rad.
  double getMaxPosition() const;
  /// ROTATIONAL.
  Type getType() const { return ROTATIONAL; }
  /// NULL: servos have no brake.
  Brake* getBrake() const { return 0; }
  /// The encoder of this joint; never NULL.
  PositionSensor* getPositionSensor() const;

  /// Stores `sampling_period` in ms. Load is read in every cycle anyway. Simulator: no values until enabled.
  virtual void enableTorqueFeedback(int sampling_period);
  /// Sets the sampling period to 0; load is still read.
  virtual void disableTorqueFeedback();
  /// ms as set last; 0: disabled.
  int getTorqueFeedbackSamplingPeriod() const { return torque_period_; }
  /// Load in N m, -2.5 to 2.5, **positive when the servo reports a clockwise load**, as in 2013 and in setTorque().
  /// The servo estimates it from its own motor drive; it is not a measured torque. NaN: no answer for more than 3
  /// cycles.
  double getTorqueFeedback() const;
  /// Same as enableTorqueFeedback(); ms.
  virtual void enableForceFeedback(int sampling_period);
  /// Same as disableTorqueFeedback().
  virtual void disableForceFeedback();
  /// Same as getTorqueFeedbackSamplingPeriod(); ms.
  int getForceFeedbackSamplingPeriod() const { return torque_period_; }
  /// Same as getTorqueFeedback(); N m.
  double getForceFeedback() const;

  // Names of 2013; today these are methods of PositionSensor.

  /// Stores `sampling_period` in ms. The position is read in every cycle anyway.
  virtual void enablePosition(int sampling_period);
  /// Sets the sampling period to 0; the position is still read.
  virtual void disablePosition();
  /// ms as set last; 0: disabled.
  int getPositionSamplingPeriod() const { return position_period_; }
  /// Measured position in rad, in steps of 2 pi / 4096. NaN: no answer for more than 3 cycles.
  /// Simulator: NaN until enabled. 2013: 0.125 % too large, and an old value after a lost answer.
  double getPosition() const;

 protected:
  Motor(const std::string& name, darwinop::webots_api::RobotImpl& robot, darwinop::goals::MotorControl& control);

 private:
  darwinop::goals::MotorControl& control_;
  int torque_period_, position_period_;
};

}  // namespace webots

#endif
