// Brake of a joint in the simulator. This robot has none: absent_devices.hpp.
#ifndef BRAKE_HPP
#define BRAKE_HPP

#include <webots/absent_devices.hpp>

namespace webots {

class Motor;
class PositionSensor;

/// No object exists here: Robot::getBrake(), Motor::getBrake() and PositionSensor::getBrake() return NULL.
class Brake : public Device {
 public:
  /// Kind of joint.
  enum Type { ROTATIONAL = 0, LINEAR = 1 };

  /// Damping of the joint, 0 or more: N m s (rotational) or N s/m (linear).
  virtual void setDampingConstant(double damping_constant) = 0;
  /// Kind of joint.
  virtual Type getType() const = 0;
  /// The motor of the same joint.
  virtual Motor* getMotor() const = 0;
  /// The encoder of the same joint.
  virtual PositionSensor* getPositionSensor() const = 0;
};

}  // namespace webots

#endif
