// Attitude sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef INERTIAL_UNIT_HPP
#define INERTIAL_UNIT_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getInertialUnit() returns NULL; an object that a controller makes has no device: see Device. Use
/// Accelerometer and Gyro.
class InertialUnit : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createInertialUnit() and a class of your own; logs one warning. See Device.
  explicit InertialUnit(const std::string& name) : AbsentSensor(name, "InertialUnit") {}
  /// Absent here: NaN. Simulator: roll, pitch and yaw in rad.
  const double* getRollPitchYaw() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: NaN. Simulator: attitude as a quaternion x, y, z, w; each -1 to 1.
  const double* getQuaternion() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: NaN. Simulator: standard deviation of the noise in rad.
  double getNoise() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: 0. Simulator: Number of rows of getLookupTable(). Until 2020.
  int getLookupTableSize() const { return 0; }
  /// Absent here: NULL. Simulator: rows of three numbers, angle in rad, returned value, noise. Until 2020.
  const double* getLookupTable() const { return 0; }
};

}  // namespace webots

#endif
