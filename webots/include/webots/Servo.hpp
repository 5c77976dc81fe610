// The motor under the class name of the thesis of 2013. Every motor of this robot is a Servo.
#ifndef SERVO_HPP
#define SERVO_HPP

#include <webots/Motor.hpp>

namespace webots {

/// Adds the method names of 2013 to Motor; units and rules are those of Motor.
class Servo : public Motor {
 public:
  /// The robot's device of this name, for Robot::createServo() and a class of your own; see Device.
  explicit Servo(const std::string& name);
  virtual ~Servo();
  /// Same as setAvailableTorque(); N m, 0 to 2.5.
  virtual void setMotorForce(double force);
  /// Same as setControlPID(p, 0, 0); Kp, 0 to 31.75.
  virtual void setControlP(double p);
  /// Same as enableTorqueFeedback(); ms.
  virtual void enableMotorForceFeedback(int sampling_period);
  /// Same as disableTorqueFeedback().
  virtual void disableMotorForceFeedback();
  /// Same as getTorqueFeedbackSamplingPeriod(); ms.
  int getMotorForceFeedbackSamplingPeriod() const { return getTorqueFeedbackSamplingPeriod(); }
  /// Same as getTorqueFeedback(); N m, positive for a clockwise load.
  double getMotorForceFeedback() const;
  /// Same as getPositionSamplingPeriod(); ms.
  int getSamplingPeriod() const { return getPositionSamplingPeriod(); }

 private:
  friend class darwinop::webots_api::RobotImpl;
  Servo(const std::string& name, darwinop::webots_api::RobotImpl& robot, darwinop::goals::MotorControl& control);
};

}  // namespace webots

#endif
