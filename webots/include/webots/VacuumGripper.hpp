// Vacuum gripper of the simulator. This robot has none: absent_devices.hpp.
#ifndef VACUUM_GRIPPER_HPP
#define VACUUM_GRIPPER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getVacuumGripper() returns NULL; an object that a controller makes has no device: see Device.
class VacuumGripper : public Device {
 public:
  /// An object without a device, for Robot::createVacuumGripper() and a class of your own; logs one warning. See
  /// Device.
  explicit VacuumGripper(const std::string& name) : Device(name, "VacuumGripper"), presence_period_(0) {}
  /// Absent here: stores `sampling_period` in ms.
  virtual void enablePresence(int sampling_period) { presence_period_ = sampling_period; }
  /// Absent here: sets the sampling period to 0.
  virtual void disablePresence() { presence_period_ = 0; }
  /// ms as set last; 0: disabled.
  int getPresenceSamplingPeriod() const { return presence_period_; }
  /// Absent here: false. Simulator: whether an object is held.
  bool getPresence() const { return false; }
  /// Absent here: false. Simulator: whether turnOn() was called last.
  bool isOn() const { return false; }
  /// Absent here: no effect. Simulator: grips.
  virtual void turnOn() {}
  /// Absent here: no effect. Simulator: releases.
  virtual void turnOff() {}

 private:
  int presence_period_;
};

}  // namespace webots

#endif
