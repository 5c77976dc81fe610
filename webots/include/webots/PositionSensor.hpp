// The position encoder of a servo: "ShoulderRS" ... "HeadS".
#ifndef POSITION_SENSOR_HPP
#define POSITION_SENSOR_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

class Brake;
class Motor;

///     const double angle = robot.getPositionSensor("NeckS")->getValue();  // rad
///     if (angle != angle) return;                                         // NaN: the servo does not answer
///
/// Reads the newest sensor image of Robot::step(). Threads: see Robot.
class PositionSensor : public Device {
 public:
  /// Kind of sensor; all are ROTATIONAL.
  enum Type { ROTATIONAL = 0, LINEAR = 1, ANGULAR = 0 };

  /// The robot's device of this name, for Robot::createPositionSensor() and a class of your own; see Device.
  explicit PositionSensor(const std::string& name);
  virtual ~PositionSensor();
  /// Stores `sampling_period` in ms. The position is read in every cycle anyway. Simulator: NaN until enabled.
  virtual void enable(int sampling_period);
  /// Sets the sampling period to 0; values are still read.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// Position in rad, in steps of 2 pi / 4096, positive as the servo counts up; the same as Motor::getPosition().
  /// NaN: the servo has not answered for more than 3 cycles.
  double getValue() const;
  /// ROTATIONAL.
  Type getType() const { return ROTATIONAL; }
  /// NULL: servos have no brake.
  Brake* getBrake() const { return 0; }
  /// The motor of this joint; never NULL.
  Motor* getMotor() const;

 private:
  friend class darwinop::webots_api::RobotImpl;
  PositionSensor(const std::string& name, darwinop::webots_api::RobotImpl& robot, unsigned joint);
  unsigned joint_;
  int period_;
};

}  // namespace webots

#endif
