// Docking connector of the simulator. This robot has none: absent_devices.hpp.
#ifndef CONNECTOR_HPP
#define CONNECTOR_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getConnector() returns NULL.
class Connector : public Device {
 public:
  /// Starts detecting peers every `sampling_period` ms.
  virtual void enablePresence(int sampling_period) = 0;
  /// Ends detecting peers.
  virtual void disablePresence() = 0;
  /// ms as set last; 0: disabled.
  virtual int getPresenceSamplingPeriod() const = 0;
  /// 1: a peer is in reach; 0 or -1: none, or not detected. No unit.
  virtual int getPresence() const = 0;
  /// Whether lock() was called last.
  virtual bool isLocked() const = 0;
  /// Attaches to a peer in reach.
  virtual void lock() = 0;
  /// Detaches.
  virtual void unlock() = 0;
};

}  // namespace webots

#endif
