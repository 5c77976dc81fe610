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

/// No object exists here: Robot::getLidar() returns NULL.
class Lidar : public AbsentSensor {
 public:
  /// Starts computing points.
  virtual void enablePointCloud() = 0;
  /// Ends computing points.
  virtual void disablePointCloud() = 0;
  /// Whether points are computed.
  virtual bool isPointCloudEnabled() const = 0;
  /// Distances in m, layer by layer.
  virtual const float* getRangeImage() const = 0;
  /// Distances of a layer in m; `layer` 0 to getNumberOfLayers() - 1.
  virtual const float* getLayerRangeImage(int layer) const = 0;
  /// Points in m, layer by layer.
  virtual const LidarPoint* getPointCloud() const = 0;
  /// Points of a layer in m; `layer` 0 to getNumberOfLayers() - 1.
  virtual const LidarPoint* getLayerPointCloud(int layer) const = 0;
  /// Number of points.
  virtual int getNumberOfPoints() const = 0;
  /// Number of points per layer.
  virtual int getHorizontalResolution() const = 0;
  /// Number of layers.
  virtual int getNumberOfLayers() const = 0;
  /// Hz.
  virtual double getMinFrequency() const = 0;
  /// Hz.
  virtual double getMaxFrequency() const = 0;
  /// Scans per s, in Hz.
  virtual double getFrequency() const = 0;
  /// Scans per s, in Hz.
  virtual void setFrequency(double frequency) = 0;
  /// Horizontal field of view in rad.
  virtual double getFov() const = 0;
  /// Vertical field of view in rad.
  virtual double getVerticalFov() const = 0;
  /// m.
  virtual double getMinRange() const = 0;
  /// m.
  virtual double getMaxRange() const = 0;
};

}  // namespace webots

#endif
