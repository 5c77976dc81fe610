// Position sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef GPS_HPP
#define GPS_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getGPS() returns NULL.
class GPS : public AbsentSensor {
 public:
  /// Meaning of getValues().
  enum CoordinateType { LOCAL = 0, WGS84 = 1 };

  /// Position: X, Y, Z in m (LOCAL), or latitude and longitude in degrees and altitude in m (WGS84).
  virtual const double* getValues() const = 0;
  /// Speed in m/s.
  virtual double getSpeed() const = 0;
  /// Velocity along X, Y, Z in m/s.
  virtual const double* getSpeedVector() const = 0;
  /// Meaning of getValues().
  virtual CoordinateType getCoordinateSystem() const = 0;
  /// Text of an angle in degrees: 12.5 becomes 12° 30′ 0″. Works here.
  static std::string convertToDegreesMinutesSeconds(double decimal_degrees);
};

}  // namespace webots

#endif
