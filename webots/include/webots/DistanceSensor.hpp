// Distance sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef DISTANCE_SENSOR_HPP
#define DISTANCE_SENSOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getDistanceSensor() returns NULL; an object that a controller makes has no device: see Device.
class DistanceSensor : public AbsentSensor {
 public:
  /// Kind of sensor.
  enum Type { GENERIC = 0, INFRA_RED = 1, SONAR = 2, LASER = 3 };

  /// An object without a device, for Robot::createDistanceSensor() and a class of your own; logs one warning. See
  /// Device.
  explicit DistanceSensor(const std::string& name) : AbsentSensor(name, "DistanceSensor") {}
  /// Absent here: NaN. Simulator: value of the lookup table for the measured distance; m if it has none.
  double getValue() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: GENERIC. Simulator: kind of sensor.
  Type getType() const { return GENERIC; }
  /// Absent here: NaN. Simulator: largest value of the lookup table; as getValue().
  double getMaxValue() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: smallest value of the lookup table; as getValue().
  double getMinValue() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: width of the beam in rad.
  double getAperture() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: 0. Simulator: Number of rows of getLookupTable().
  int getLookupTableSize() const { return 0; }
  /// Absent here: NULL. Simulator: rows of three numbers, distance in m, returned value, noise.
  const double* getLookupTable() const { return 0; }
};

}  // namespace webots

#endif
