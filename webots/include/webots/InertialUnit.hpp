// Attitude sensor of the simulator. This robot has none: absent_devices.hpp.
#ifndef INERTIAL_UNIT_HPP
#define INERTIAL_UNIT_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getInertialUnit() returns NULL. Use Accelerometer and Gyro.
class InertialUnit : public AbsentSensor {
 public:
  /// Roll, pitch and yaw in rad.
  virtual const double* getRollPitchYaw() const = 0;
  /// Attitude as a quaternion x, y, z, w; each -1 to 1.
  virtual const double* getQuaternion() const = 0;
  /// Standard deviation of the noise in rad.
  virtual double getNoise() const = 0;
  /// Number of rows of getLookupTable(). Until 2020.
  virtual int getLookupTableSize() const = 0;
  /// Rows of three numbers: angle in rad, returned value, noise. Until 2020.
  virtual const double* getLookupTable() const = 0;
};

}  // namespace webots

#endif
