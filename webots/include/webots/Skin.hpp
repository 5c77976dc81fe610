// Animated mesh of the simulator. This robot has none: absent_devices.hpp.
#ifndef SKIN_HPP
#define SKIN_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getSkin() returns NULL; an object that a controller makes has no device: see Device.
class Skin : public Device {
 public:
  /// An object without a device, for Robot::createSkin() and a class of your own; logs one warning. See Device.
  explicit Skin(const std::string& name) : Device(name, "Skin") {}
  /// Absent here: no effect. Simulator: turns a bone; `orientation` is axis and angle (rad), `index` 0 to
  /// getBoneCount() - 1.
  virtual void setBoneOrientation(int /*index*/, const double /*orientation*/[4], bool /*absolute*/) {}
  /// Absent here: no effect. Simulator: moves a bone to a position in m.
  virtual void setBonePosition(int /*index*/, const double /*position*/[3], bool /*absolute*/) {}
  /// Absent here: 0. Simulator: Number of bones.
  int getBoneCount() const { return 0; }
  /// Absent here: empty. Simulator: name of a bone; `index` 0 to getBoneCount() - 1, no unit.
  std::string getBoneName(int /*index*/) const { return std::string(); }
  /// Absent here: NaN. Simulator: axis and angle (rad) of a bone.
  const double* getBoneOrientation(int /*index*/, bool /*absolute*/) const {
    return darwinop::webots_api::absentNumbers();
  }
  /// Absent here: NaN. Simulator: position of a bone in m.
  const double* getBonePosition(int /*index*/, bool /*absolute*/) const {
    return darwinop::webots_api::absentNumbers();
  }
};

}  // namespace webots

#endif
