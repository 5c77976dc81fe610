// Pen of the simulator. This robot has none: absent_devices.hpp.
#ifndef PEN_HPP
#define PEN_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getPen() returns NULL; an object that a controller makes has no device: see Device.
class Pen : public Device {
 public:
  /// An object without a device, for Robot::createPen() and a class of your own; logs one warning. See Device.
  explicit Pen(const std::string& name) : Device(name, "Pen") {}
  /// Absent here: no effect. Simulator: whether the pen touches the floor.
  virtual void write(bool /*write*/) {}
  /// Absent here: no effect. Simulator: `color` 0 to 0xFFFFFF, 0xRRGGBB; `density` 0 to 1.
  virtual void setInkColor(int /*color*/, double /*density*/) {}
};

}  // namespace webots

#endif
