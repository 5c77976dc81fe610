// Position sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef GPS_HPP
#define GPS_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getGPS() returns NULL; an object that a controller makes has no device: see Device.
class GPS : public AbsentSensor {
 public:
  /// Meaning of getValues().
  enum CoordinateType { LOCAL = 0, WGS84 = 1 };

  /// An object without a device, for Robot::createGPS() and a class of your own; logs one warning. See Device.
  explicit GPS(const std::string& name) : AbsentSensor(name, "GPS") {}
  /// Absent here: NaN. Simulator: X, Y, Z in m (LOCAL), or latitude and longitude in degrees and
  /// altitude in m (WGS84).
  const double* getValues() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: NaN. Simulator: speed in m/s.
  double getSpeed() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: velocity along X, Y, Z in m/s.
  const double* getSpeedVector() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: LOCAL. Simulator: meaning of getValues().
  CoordinateType getCoordinateSystem() const { return LOCAL; }
  /// Text of an angle in degrees: 12.5 becomes 12° 30′ 0″. Works here.
  static std::string convertToDegreesMinutesSeconds(double decimal_degrees);
};

}  // namespace webots

#endif
