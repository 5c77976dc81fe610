// The accelerometer of the CM-730 board, "Accelerometer".
#ifndef ACCELEROMETER_HPP
#define ACCELEROMETER_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace webots {

///     const double* a = accelerometer->getValues();   // keeps pointing to the newest values
///     const double up_in_g = (a[2] - 512) / 128;      // 1 for an upright robot
///
/// Raw counts of the board, as in the simulator's model and in 2013, not SI units. Threads: see Robot.
class Accelerometer : public Device {
 public:
  /// The robot's device of this name, for Robot::createAccelerometer() and a class of your own; see Device.
  explicit Accelerometer(const std::string& name);
  virtual ~Accelerometer();
  /// Stores `sampling_period` in ms. Values are read in every cycle anyway. Simulator: no values until enabled.
  virtual void enable(int sampling_period);
  /// Sets the sampling period to 0; values are still read.
  virtual void disable();
  /// ms as set last; 0: disabled.
  int getSamplingPeriod() const { return period_; }
  /// Three raw counts, 0 to 1023, for the axes X (right), Y (forward), Z (up); 512 is 0, and 128 counts are 1 g by the
  /// board's firmware (the user guide has 3 g for half the range; no robot was measured). An upright robot reads 512,
  /// 512, 640. The pointer stays valid as long as the robot, and the values change in every step. NaN: the board has
  /// not answered for more than 3 cycles.
  const double* getValues() const;
  /// Number of rows of getLookupTable(): 2.
  int getLookupTableSize() const { return 2; }
  /// Two rows of three numbers, for counts 0 and 1024: value in m/s2, count, noise (0). Linear in between.
  const double* getLookupTable() const { return lookup_; }

 private:
  friend class darwinop::webots_api::RobotImpl;
  Accelerometer(const std::string& name, darwinop::webots_api::RobotImpl& robot);
  /// NULL: too old.
  virtual void refresh();
  double values_[3];
  double lookup_[6];
  int period_;
};

}  // namespace webots

#endif
