// Altitude sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef ALTIMETER_HPP
#define ALTIMETER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getAltimeter() returns NULL; an object that a controller makes has no device: see Device.
class Altimeter : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createAltimeter() and a class of your own; logs one warning. See Device.
  explicit Altimeter(const std::string& name) : AbsentSensor(name, "Altimeter") {}
  /// Absent here: NaN. Simulator: altitude in m above the world's origin.
  double getValue() const { return darwinop::webots_api::absentNumber(); }
};

}  // namespace webots

#endif
