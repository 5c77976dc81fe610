// Distance sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef DISTANCE_SENSOR_HPP
#define DISTANCE_SENSOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getDistanceSensor() returns NULL.
class DistanceSensor : public AbsentSensor {
 public:
  /// Kind of sensor.
  enum Type { GENERIC = 0, INFRA_RED = 1, SONAR = 2, LASER = 3 };

  /// Value of the lookup table for the measured distance; m if it has none.
  virtual double getValue() const = 0;
  /// Kind of sensor.
  virtual Type getType() const = 0;
  /// Largest value of the lookup table; as getValue().
  virtual double getMaxValue() const = 0;
  /// Smallest value of the lookup table; as getValue().
  virtual double getMinValue() const = 0;
  /// Width of the beam in rad.
  virtual double getAperture() const = 0;
  /// Number of rows of getLookupTable().
  virtual int getLookupTableSize() const = 0;
  /// Rows of three numbers: distance in m, returned value, noise.
  virtual const double* getLookupTable() const = 0;
};

}  // namespace webots

#endif
