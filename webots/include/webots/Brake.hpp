// Brake of a joint in the simulator. This robot has none: absent_devices.hpp.
#ifndef BRAKE_HPP
#define BRAKE_HPP

#include <webots/absent_devices.hpp>

namespace webots {

class Motor;
class PositionSensor;

/// Robot::getBrake(), Motor::getBrake() and PositionSensor::getBrake() return NULL; an object that a controller makes
/// has no device: see Device.
class Brake : public Device {
 public:
  /// Kind of joint.
  enum Type { ROTATIONAL = 0, LINEAR = 1 };

  /// An object without a device, for Robot::createBrake() and a class of your own; logs one warning. See Device.
  explicit Brake(const std::string& name) : Device(name, "Brake") {}
  /// Absent here: no effect. Simulator: damping of the joint, 0 or more: N m s (rotational) or N s/m (linear).
  virtual void setDampingConstant(double /*damping_constant*/) {}
  /// Absent here: ROTATIONAL. Simulator: kind of joint.
  Type getType() const { return ROTATIONAL; }
  /// Absent here: NULL. Simulator: the motor of the same joint.
  Motor* getMotor() const { return 0; }
  /// Absent here: NULL. Simulator: the encoder of the same joint.
  PositionSensor* getPositionSensor() const { return 0; }
};

}  // namespace webots

#endif
