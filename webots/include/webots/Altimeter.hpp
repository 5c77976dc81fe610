// Altitude sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef ALTIMETER_HPP
#define ALTIMETER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getAltimeter() returns NULL.
class Altimeter : public AbsentSensor {
 public:
  /// Altitude in m above the world's origin.
  virtual double getValue() const = 0;
};

}  // namespace webots

#endif
