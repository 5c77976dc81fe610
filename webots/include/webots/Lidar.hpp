// Laser scanner of the simulator. This robot has none: absent_devices.hpp.
#ifndef LIDAR_HPP
#define LIDAR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// One point of Lidar::getPointCloud().
struct LidarPoint {
  float x, y, z;  // m
  int layer_id;
  float time;  // s
};

/// Robot::getLidar() returns NULL; an object that a controller makes has no device: see Device.
class Lidar : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createLidar() and a class of your own; logs one warning. See Device.
  explicit Lidar(const std::string& name) : AbsentSensor(name, "Lidar") {}
  /// Absent here: no effect. Simulator: starts computing points.
  virtual void enablePointCloud() {}
  /// Absent here: no effect. Simulator: ends computing points.
  virtual void disablePointCloud() {}
  /// Absent here: false. Simulator: whether points are computed.
  bool isPointCloudEnabled() const { return false; }
  /// Absent here: NULL. Simulator: distances in m, layer by layer.
  const float* getRangeImage() const { return 0; }
  /// Absent here: NULL. Simulator: distances of a layer in m; `layer` 0 to getNumberOfLayers() - 1.
  const float* getLayerRangeImage(int /*layer*/) const { return 0; }
  /// Absent here: NULL. Simulator: points in m, layer by layer.
  const LidarPoint* getPointCloud() const { return 0; }
  /// Absent here: NULL. Simulator: points of a layer in m; `layer` 0 to getNumberOfLayers() - 1.
  const LidarPoint* getLayerPointCloud(int /*layer*/) const { return 0; }
  /// Absent here: 0. Simulator: Number of points.
  int getNumberOfPoints() const { return 0; }
  /// Absent here: 0. Simulator: Number of points per layer.
  int getHorizontalResolution() const { return 0; }
  /// Absent here: 0. Simulator: Number of layers.
  int getNumberOfLayers() const { return 0; }
  /// Absent here: NaN. Simulator: Hz.
  double getMinFrequency() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: Hz.
  double getMaxFrequency() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: scans per s, in Hz.
  double getFrequency() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: no effect. Simulator: scans per s, in Hz.
  virtual void setFrequency(double /*frequency*/) {}
  /// Absent here: NaN. Simulator: horizontal field of view in rad.
  double getFov() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: vertical field of view in rad.
  double getVerticalFov() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: m.
  double getMinRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: m.
  double getMaxRange() const { return darwinop::webots_api::absentNumber(); }
};

}  // namespace webots

#endif
