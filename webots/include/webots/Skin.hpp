// Animated mesh of the simulator. This robot has none: absent_devices.hpp.
#ifndef SKIN_HPP
#define SKIN_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getSkin() returns NULL.
class Skin : public Device {
 public:
  /// Turns a bone: `orientation` is axis and angle (rad); `index` 0 to getBoneCount() - 1.
  virtual void setBoneOrientation(int index, const double orientation[4], bool absolute) = 0;
  /// Moves a bone to a position in m.
  virtual void setBonePosition(int index, const double position[3], bool absolute) = 0;
  /// Number of bones.
  virtual int getBoneCount() const = 0;
  /// Name of a bone; `index` 0 to getBoneCount() - 1, no unit.
  virtual std::string getBoneName(int index) const = 0;
  /// Axis and angle (rad) of a bone.
  virtual const double* getBoneOrientation(int index, bool absolute) const = 0;
  /// Position of a bone in m.
  virtual const double* getBonePosition(int index, bool absolute) const = 0;
};

}  // namespace webots

#endif
