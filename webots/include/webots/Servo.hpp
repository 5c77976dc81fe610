// The motor under its first name, of the 2013 thesis. Every motor of this robot is one.
#ifndef SERVO_HPP
#define SERVO_HPP

#include <webots/Motor.hpp>

namespace webots {

class Servo : public Motor {
 public:
  virtual ~Servo();
  /// setAvailableTorque().
  virtual void setMotorForce(double force);
  /// setControlPID(p, 0, 0).
  virtual void setControlP(double p);
  /// Torque feedback.
  virtual void enableMotorForceFeedback(int sampling_period);
  virtual void disableMotorForceFeedback();
  int getMotorForceFeedbackSamplingPeriod() const { return getTorqueFeedbackSamplingPeriod(); }
  double getMotorForceFeedback() const;
  int getSamplingPeriod() const { return getPositionSamplingPeriod(); }

 private:
  friend class darwinop::facade::RobotImpl;
  Servo(const std::string& name, darwinop::facade::RobotImpl& robot, darwinop::MotorControl& control);
};

}  // namespace webots

#endif
