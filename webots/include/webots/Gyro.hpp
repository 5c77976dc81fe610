// The gyroscope of the CM-730 board, "Gyro".
#ifndef GYRO_HPP
#define GYRO_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace darwinop {
struct BoardSensors;
}

namespace webots {

class Gyro : public Device {
 public:
  virtual ~Gyro();
  /// Values are read in every step, enabled or not.
  virtual void enable(int sampling_period);
  virtual void disable();
  int getSamplingPeriod() const { return period_; }
  /// Three raw counts 0..1023, axes X, Y, Z; 3.584 deg/s a count; at rest 512, 512, 512. The pointer stays valid, the
  /// values change with every step. NaN: the board has not answered for 3 cycles.
  const double* getValues() const;
  /// Two rows of SI value, count, 0: the law between them is a straight line.
  int getLookupTableSize() const { return 2; }
  const double* getLookupTable() const { return lookup_; }

 private:
  friend class darwinop::facade::RobotImpl;
  Gyro(const std::string& name, darwinop::facade::RobotImpl& robot);
  /// NULL: too old.
  void refresh(const darwinop::BoardSensors* board);
  double values_[3];
  double lookup_[6];
  int period_;
};

}  // namespace webots

#endif
