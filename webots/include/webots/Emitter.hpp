// Radio or infra-red sender of the simulator. This robot has none: absent_devices.hpp.
#ifndef EMITTER_HPP
#define EMITTER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getEmitter() returns NULL. Use a socket to reach other programs.
class Emitter : public Device {
 public:
  /// Channel that every receiver receives.
  enum { CHANNEL_BROADCAST = -1 };

  /// Queues `size` bytes for the next step. 1: queued; 0: the buffer is full.
  virtual int send(const void* data, int size) = 0;
  /// Channel from here on, -1 to 2147483647.
  virtual void setChannel(int channel) = 0;
  /// Channel, -1 to 2147483647.
  virtual int getChannel() const = 0;
  /// Range in m; -1: unlimited.
  virtual void setRange(double range) = 0;
  /// Range in m; -1: unlimited.
  virtual double getRange() const = 0;
  /// Size of the buffer in bytes; -1: unlimited.
  virtual int getBufferSize() const = 0;
};

}  // namespace webots

#endif
