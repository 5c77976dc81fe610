// Depth camera of the simulator. This robot has none: absent_devices.hpp.
#ifndef RANGE_FINDER_HPP
#define RANGE_FINDER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getRangeFinder() returns NULL.
class RangeFinder : public AbsentSensor {
 public:
  /// Distances in m, getWidth() x getHeight(), rows from top to bottom.
  virtual const float* getRangeImage() const = 0;
  /// Pixels.
  virtual int getWidth() const = 0;
  /// Pixels.
  virtual int getHeight() const = 0;
  /// Horizontal field of view in rad.
  virtual double getFov() const = 0;
  /// m.
  virtual double getMinRange() const = 0;
  /// m.
  virtual double getMaxRange() const = 0;
  /// Writes the image to a file; `quality` 1 to 100. 0: written; -1: error.
  virtual int saveImage(const std::string& filename, int quality) const = 0;
  /// Distance in m of pixel x, y of an image that is `width` pixels wide. No range check. Works here.
  static float rangeImageGetDepth(const float* image, int width, int x, int y) { return image[y * width + x]; }
};

}  // namespace webots

#endif
