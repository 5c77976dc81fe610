// Radio or infra-red receiver of the simulator. This robot has none: absent_devices.hpp.
#ifndef RECEIVER_HPP
#define RECEIVER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// No object exists here: Robot::getReceiver() returns NULL. Use a socket to reach other programs.
class Receiver : public AbsentSensor {
 public:
  /// Channel that receives from every sender.
  enum { CHANNEL_BROADCAST = -1 };

  /// Number of packets received and not removed.
  virtual int getQueueLength() const = 0;
  /// Removes the first packet.
  virtual void nextPacket() = 0;
  /// Data of the first packet, getDataSize() bytes.
  virtual const void* getData() const = 0;
  /// Size of the first packet in bytes.
  virtual int getDataSize() const = 0;
  /// Strength of the first packet: 1 / (distance in m)^2; no unit.
  virtual double getSignalStrength() const = 0;
  /// Direction of the sender of the first packet: a unit vector, components -1 to 1.
  virtual const double* getEmitterDirection() const = 0;
  /// Channel from here on, -1 to 2147483647.
  virtual void setChannel(int channel) = 0;
  /// Channel, -1 to 2147483647.
  virtual int getChannel() const = 0;
};

}  // namespace webots

#endif
