// Light sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef LIGHT_SENSOR_HPP
#define LIGHT_SENSOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getLightSensor() returns NULL.
class LightSensor : public AbsentSensor {
 public:
  /// Value of the lookup table for the irradiance; no unit.
  virtual double getValue() const = 0;
  /// Number of rows of getLookupTable().
  virtual int getLookupTableSize() const = 0;
  /// Rows of three numbers: irradiance in W/m2, returned value, noise; no unit of their own.
  virtual const double* getLookupTable() const = 0;
};

}  // namespace webots

#endif
