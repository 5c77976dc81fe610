// Compass of the simulator. This robot has none: absent_devices.hpp.
#ifndef COMPASS_HPP
#define COMPASS_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getCompass() returns NULL. Integrate the gyroscope for a heading.
class Compass : public AbsentSensor {
 public:
  /// Direction of north in the axes X, Y, Z of the sensor: three components of a unit vector, -1 to 1.
  virtual const double* getValues() const = 0;
  /// Number of rows of getLookupTable().
  virtual int getLookupTableSize() const = 0;
  /// Rows of three numbers: component -1 to 1, returned value, noise.
  virtual const double* getLookupTable() const = 0;
};

}  // namespace webots

#endif
