// A push button on the robot's back: "ButtonMode", "ButtonStart". Ours: neither simulator nor 2013 had them.
#ifndef TOUCH_SENSOR_HPP
#define TOUCH_SENSOR_HPP

#include <webots/Device.hpp>

namespace webots {

class TouchSensor : public Device {
 public:
  enum Type { BUMPER = 0, FORCE = 1, FORCE3D = 2 };

  virtual ~TouchSensor();
  /// Values are read in every step, enabled or not.
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// 1 pressed, 0 not. NaN: the board has not answered for 3 cycles.
  double getValue() const;
  Type getType() const { return BUMPER; }

 private:
  friend class darwinop::facade::RobotImpl;
  TouchSensor(const std::string& name, darwinop::facade::RobotImpl& robot, int bit);
  int bit_, period_;
};

}  // namespace webots

#endif
