// Vacuum gripper of the simulator. This robot has none: absent_devices.hpp.
#ifndef VACUUM_GRIPPER_HPP
#define VACUUM_GRIPPER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getVacuumGripper() returns NULL.
class VacuumGripper : public Device {
 public:
  /// Starts detecting objects every `sampling_period` ms.
  virtual void enablePresence(int sampling_period) = 0;
  /// Ends detecting objects.
  virtual void disablePresence() = 0;
  /// ms as set last; 0: disabled.
  virtual int getPresenceSamplingPeriod() const = 0;
  /// Whether an object is held.
  virtual bool getPresence() const = 0;
  /// Whether turnOn() was called last.
  virtual bool isOn() const = 0;
  /// Grips.
  virtual void turnOn() = 0;
  /// Releases.
  virtual void turnOff() = 0;
};

}  // namespace webots

#endif
