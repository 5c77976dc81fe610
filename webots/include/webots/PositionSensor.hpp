// The encoder of a servo: "ShoulderRS" ... "HeadS".
#ifndef POSITION_SENSOR_HPP
#define POSITION_SENSOR_HPP

#include <webots/Device.hpp>

namespace webots {

class Brake;
class Motor;

class PositionSensor : public Device {
 public:
  enum Type { ROTATIONAL = 0, LINEAR = 1, ANGULAR = 0 };

  virtual ~PositionSensor();
  /// Values are read in every step, enabled or not.
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// rad, in steps of 2 pi / 4096. NaN: the servo has not answered for 3 cycles.
  double getValue() const;
  Type getType() const { return ROTATIONAL; }
  /// NULL: servos have none.
  Brake* getBrake() const { return 0; }
  Motor* getMotor() const;

 private:
  friend class darwinop::facade::RobotImpl;
  PositionSensor(const std::string& name, darwinop::facade::RobotImpl& robot, unsigned joint);
  unsigned joint_;
  int period_;
};

}  // namespace webots

#endif
