// A push button on the robot's back: "ButtonMode", "ButtonStart". An extension: the simulator and 2013 lack them.
#ifndef TOUCH_SENSOR_HPP
#define TOUCH_SENSOR_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

///     if (robot.getTouchSensor("ButtonStart")->getValue() == 1) walk();
///
/// RESET is not a device: it cuts the supply of the servos. MODE held for 0.25 s releases all joints, unless config.ini
/// has `release_button = none`. START held for 0.25 s resets latched faults after the controller has ended
/// (docs/faults.md).
class TouchSensor : public Device {
 public:
  /// Kind of sensor; both are BUMPER.
  enum Type { BUMPER = 0, FORCE = 1, FORCE3D = 2 };

  /// The robot's device of this name, for Robot::createTouchSensor() and a class of your own; see Device.
  explicit TouchSensor(const std::string& name);
  virtual ~TouchSensor();
  /// Stores `sampling_period` in ms. Buttons are read in every cycle anyway. Simulator: NaN until enabled.
  virtual void enable(int sampling_period);
  /// Sets the sampling period to 0; values are still read.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// 0 or 1; 1: pressed. NaN: the board has not answered for more than 3 cycles, or over TCP the server does not send
  /// buttons.
  double getValue() const;
  /// Absent here: NULL, with one warning; only a FORCE3D sensor has three values. Simulator: as
  /// getValue(), per axis.
  const double* getValues() const;
  /// Absent here: 0. Number of rows of getLookupTable().
  int getLookupTableSize() const { return 0; }
  /// Absent here: NULL, a button has no table; no unit.
  const double* getLookupTable() const { return 0; }
  /// BUMPER.
  Type getType() const { return BUMPER; }

 private:
  friend class darwinop::webots_api::RobotImpl;
  TouchSensor(const std::string& name, darwinop::webots_api::RobotImpl& robot, int bit);
  int bit_, period_;
};

}  // namespace webots

#endif
