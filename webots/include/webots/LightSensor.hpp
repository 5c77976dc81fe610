// Light sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef LIGHT_SENSOR_HPP
#define LIGHT_SENSOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getLightSensor() returns NULL; an object that a controller makes has no device: see Device.
class LightSensor : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createLightSensor() and a class of your own; logs one warning. See Device.
  explicit LightSensor(const std::string& name) : AbsentSensor(name, "LightSensor") {}
  /// Absent here: NaN. Simulator: value of the lookup table for the irradiance; no unit.
  double getValue() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: 0. Simulator: Number of rows of getLookupTable().
  int getLookupTableSize() const { return 0; }
  /// Absent here: NULL. Simulator: rows of three numbers, irradiance in W/m2, returned value, noise; no unit of their
  /// own.
  const double* getLookupTable() const { return 0; }
};

}  // namespace webots

#endif
