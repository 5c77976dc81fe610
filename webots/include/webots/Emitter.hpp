// Radio or infra-red sender of the simulator. This robot has none: absent_devices.hpp.
#ifndef EMITTER_HPP
#define EMITTER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getEmitter() returns NULL; an object that a controller makes has no device: see Device. Use a socket to reach
/// other programs.
class Emitter : public Device {
 public:
  /// Channel that every receiver receives.
  enum { CHANNEL_BROADCAST = -1 };

  /// An object without a device, for Robot::createEmitter() and a class of your own; logs one warning. See Device.
  explicit Emitter(const std::string& name) : Device(name, "Emitter") {}
  /// Absent here: 0. Simulator: queues `size` bytes for the next step. 1: queued; 0: the buffer is full.
  virtual int send(const void* /*data*/, int /*size*/) { return 0; }
  /// Absent here: no effect. Simulator: channel from here on, -1 to 2147483647.
  virtual void setChannel(int /*channel*/) {}
  /// Absent here: -1. Simulator: channel, -1 to 2147483647.
  int getChannel() const { return -1; }
  /// Absent here: no effect. Simulator: range in m; -1: unlimited.
  virtual void setRange(double /*range*/) {}
  /// Absent here: NaN. Simulator: range in m; -1: unlimited.
  double getRange() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: 0. Simulator: size of the buffer in bytes; -1: unlimited.
  int getBufferSize() const { return 0; }
};

}  // namespace webots

#endif
