// Compass of the simulator. This robot has none: absent_devices.hpp.
#ifndef COMPASS_HPP
#define COMPASS_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getCompass() returns NULL; an object that a controller makes has no device: see Device. Integrate the
/// gyroscope for a heading.
class Compass : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createCompass() and a class of your own; logs one warning. See Device.
  explicit Compass(const std::string& name) : AbsentSensor(name, "Compass") {}
  /// Absent here: NaN. Simulator: direction of north in the axes X, Y, Z of the sensor: three components of a unit
  /// vector, -1 to 1.
  const double* getValues() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: 0. Simulator: Number of rows of getLookupTable().
  int getLookupTableSize() const { return 0; }
  /// Absent here: NULL. Simulator: rows of three numbers, component -1 to 1, returned value, noise.
  const double* getLookupTable() const { return 0; }
};

}  // namespace webots

#endif
