// A servo motor of the robot: "ShoulderR" ... "Head".
#ifndef MOTOR_HPP
#define MOTOR_HPP

#include <math.h>

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace darwinop {
class MotorControl;
}

namespace webots {

class Brake;
class PositionSensor;

/// A call takes effect with the next Robot::step(). Angles in rad, speeds in rad/s, torques in N m.
class Motor : public Device {
 public:
  enum Type { ROTATIONAL = 0, LINEAR = 1 };

  virtual ~Motor();

  /// Goal in rad. Outside the joint's range it is clamped, and counted. INFINITY: velocity control, see setVelocity.
  virtual void setPosition(double position);
  /// Goal given last, in rad; before the first one, the goal the robot holds.
  double getTargetPosition() const;
  /// Greatest speed on the way to the goal; the sign is ignored. After setPosition(INFINITY) the sign is the
  /// direction, the joint moves until its limit, and 0 holds it where it is.
  virtual void setVelocity(double velocity);
  /// Ramp of the speed in rad/s2, never above setVelocity. -1 (default): none.
  virtual void setAcceleration(double acceleration);
  /// Greatest torque, up to 2.5. 0 or less: the joint is limp until a positive value.
  virtual void setAvailableTorque(double torque);
  virtual void setAvailableForce(double force);
  /// Pushes against an end of the range with this torque: positive towards getMinPosition(), as in 2013.
  /// 0: limp. setPosition() ends it.
  virtual void setTorque(double torque);
  virtual void setForce(double force);
  /// p is Kp of the servo, 0 to 31.75, default 4. i and d have no effect.
  virtual void setControlPID(double p, double i, double d);

  double getVelocity() const;
  double getMaxVelocity() const;
  double getAcceleration() const;
  double getAvailableTorque() const;
  double getAvailableForce() const;
  double getMaxTorque() const;
  double getMaxForce() const;
  double getMultiplier() const;
  double getMinPosition() const;
  double getMaxPosition() const;
  Type getType() const { return ROTATIONAL; }
  /// NULL: servos have none.
  Brake* getBrake() const { return 0; }
  PositionSensor* getPositionSensor() const;

  /// Feedback is read in every step, enabled or not. NaN: the servo has not answered for 3 cycles.
  virtual void enableTorqueFeedback(int sampling_period);
  virtual void disableTorqueFeedback();
  int getTorqueFeedbackSamplingPeriod() const { return torque_period_; }
  /// N m, positive when the servo reports a clockwise load, as in 2013.
  double getTorqueFeedback() const;
  virtual void enableForceFeedback(int sampling_period);
  virtual void disableForceFeedback();
  int getForceFeedbackSamplingPeriod() const { return torque_period_; }
  double getForceFeedback() const;

  // Names of 2013; today they are those of PositionSensor.
  virtual void enablePosition(int sampling_period);
  virtual void disablePosition();
  int getPositionSamplingPeriod() const { return position_period_; }
  double getPosition() const;

 protected:
  Motor(const std::string& name, darwinop::facade::RobotImpl& robot, darwinop::MotorControl& control);

 private:
  darwinop::MotorControl& control_;
  int torque_period_, position_period_;
};

}  // namespace webots

#endif
