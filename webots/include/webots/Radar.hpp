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

/// Robot::getRadar() returns NULL; an object that a controller makes has no device: see Device.
class Radar : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createRadar() and a class of your own; logs one warning. See Device.
  explicit Radar(const std::string& name) : AbsentSensor(name, "Radar") {}
  /// Absent here: NaN. Simulator: m.
  double getMinRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: m.
  double getMaxRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: horizontal field of view in rad.
  double getHorizontalFov() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: vertical field of view in rad.
  double getVerticalFov() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: 0. Simulator: Number of getTargets().
  int getNumberOfTargets() const { return 0; }
  /// Absent here: NULL. Simulator: targets in view; m, m/s and rad.
  const RadarTarget* getTargets() const { return 0; }
};

}  // namespace webots

#endif
