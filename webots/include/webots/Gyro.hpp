// The gyroscope of the CM-730 board, "Gyro".
#ifndef GYRO_HPP
#define GYRO_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

///     const double* w = gyro->getValues();                   // keeps pointing to the newest values
///     const double yaw_in_deg_per_s = (w[2] - 512) * 3.584;
///
/// Raw counts of the board, as in the simulator's model and in 2013, not SI units. Threads: see Robot.
class Gyro : public Device {
 public:
  /// The robot's device of this name, for Robot::createGyro() and a class of your own; see Device.
  explicit Gyro(const std::string& name);
  virtual ~Gyro();
  /// Stores `sampling_period` in ms. Values are read in every cycle anyway. Simulator: no values until enabled.
  virtual void enable(int sampling_period);
  /// Sets the sampling period to 0; values are still read.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// Three raw counts, 0 to 1023, for the axes X (backward), Y (right), Z (up), by the right-hand rule; 512 is 0, and
  /// one count is 3.584 deg/s by the board's firmware (the user guide has 1600 deg/s for half the range; no robot was
  /// measured, see core/registers.hpp). The pointer stays valid as long as the robot, and the values change in every
  /// step. NaN: the board has not answered for more than 3 cycles.
  const double* getValues() const;
  /// Number of rows of getLookupTable(): 2.
  int getLookupTableSize() const { return 2; }
  /// Two rows of three numbers, for counts 0 and 1024: value in rad/s, count, noise (0). Linear in between.
  const double* getLookupTable() const { return lookup_; }

 private:
  friend class darwinop::webots_api::RobotImpl;
  Gyro(const std::string& name, darwinop::webots_api::RobotImpl& robot);
  /// NULL: too old.
  virtual void refresh();
  double values_[3];
  double lookup_[6];
  int period_;
};

}  // namespace webots

#endif
