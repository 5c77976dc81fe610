// Depth camera of the simulator. This robot has none: absent_devices.hpp.
#ifndef RANGE_FINDER_HPP
#define RANGE_FINDER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getRangeFinder() returns NULL; an object that a controller makes has no device: see Device.
class RangeFinder : public AbsentSensor {
 public:
  /// An object without a device, for Robot::createRangeFinder() and a class of your own; logs one warning. See Device.
  explicit RangeFinder(const std::string& name) : AbsentSensor(name, "RangeFinder") {}
  /// Absent here: NULL. Simulator: distances in m, getWidth() x getHeight(), rows from top to bottom.
  const float* getRangeImage() const { return 0; }
  /// Absent here: 0. Simulator: pixels.
  int getWidth() const { return 0; }
  /// Absent here: 0. Simulator: pixels.
  int getHeight() const { return 0; }
  /// Absent here: NaN. Simulator: horizontal field of view in rad.
  double getFov() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: m.
  double getMinRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: m.
  double getMaxRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: writes no file and returns -1. Simulator: `quality` is 1 to 100; 0: written, -1: error.
  int saveImage(const std::string& /*filename*/, int /*quality*/) const { return -1; }
  /// Distance in m of pixel x, y of an image that is `width` pixels wide; NaN without an image. No range check. Works
  /// here.
  static float rangeImageGetDepth(const float* image, int width, int x, int y) {
    return image == 0 ? static_cast<float>(darwinop::webots_api::absentNumber()) : image[y * width + x];
  }
};

}  // namespace webots

#endif
