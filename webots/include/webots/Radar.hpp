// Radar of the simulator. This robot has none: absent_devices.hpp.
#ifndef RADAR_HPP
#define RADAR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// One target of Radar::getTargets().
struct RadarTarget {
  double distance;        // m
  double received_power;  // dBm
  double speed;           // m/s
  double azimuth;         // rad
};

/// No object exists here: Robot::getRadar() returns NULL.
class Radar : public AbsentSensor {
 public:
  /// m.
  virtual double getMinRange() const = 0;
  /// m.
  virtual double getMaxRange() const = 0;
  /// Horizontal field of view in rad.
  virtual double getHorizontalFov() const = 0;
  /// Vertical field of view in rad.
  virtual double getVerticalFov() const = 0;
  /// Number of getTargets().
  virtual int getNumberOfTargets() const = 0;
  /// Targets in view; m, m/s and rad.
  virtual const RadarTarget* getTargets() const = 0;
};

}  // namespace webots

#endif
