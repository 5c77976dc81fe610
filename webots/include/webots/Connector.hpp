// Docking connector of the simulator. This robot has none: absent_devices.hpp.
#ifndef CONNECTOR_HPP
#define CONNECTOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getConnector() returns NULL; an object that a controller makes has no device: see Device.
class Connector : public Device {
 public:
  /// An object without a device, for Robot::createConnector() and a class of your own; logs one warning. See Device.
  explicit Connector(const std::string& name) : Device(name, "Connector"), presence_period_(0) {}
  /// Absent here: stores `sampling_period` in ms.
  virtual void enablePresence(int sampling_period) { presence_period_ = sampling_period; }
  /// Absent here: sets the sampling period to 0.
  virtual void disablePresence() { presence_period_ = 0; }
  /// ms as set last; 0: disabled.
  int getPresenceSamplingPeriod() const { return presence_period_; }
  /// Absent here: -1. Simulator: 1 for a peer in reach; 0 or -1: none, or not detected. No unit.
  int getPresence() const { return -1; }
  /// Absent here: false. Simulator: whether lock() was called last.
  bool isLocked() const { return false; }
  /// Absent here: no effect. Simulator: attaches to a peer in reach.
  virtual void lock() {}
  /// Absent here: no effect. Simulator: detaches.
  virtual void unlock() {}

 private:
  int presence_period_;
};

}  // namespace webots

#endif
