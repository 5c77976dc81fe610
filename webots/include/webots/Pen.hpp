// Pen of the simulator. This robot has none: absent_devices.hpp.
#ifndef PEN_HPP
#define PEN_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getPen() returns NULL.
class Pen : public Device {
 public:
  /// Whether the pen touches the floor.
  virtual void write(bool write) = 0;
  /// `color` 0 to 0xFFFFFF, 0xRRGGBB; `density` 0 to 1.
  virtual void setInkColor(int color, double density) = 0;
};

}  // namespace webots

#endif
