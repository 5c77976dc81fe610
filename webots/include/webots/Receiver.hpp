// Radio or infra-red receiver of the simulator. This robot has none: absent_devices.hpp.
#ifndef RECEIVER_HPP
#define RECEIVER_HPP

#include <webots/absent_devices.hpp>

namespace webots {

/// Robot::getReceiver() returns NULL; an object that a controller makes has no device: see Device. Use a socket to
/// reach other programs.
class Receiver : public AbsentSensor {
 public:
  /// Channel that receives from every sender.
  enum { CHANNEL_BROADCAST = -1 };

  /// An object without a device, for Robot::createReceiver() and a class of your own; logs one warning. See Device.
  explicit Receiver(const std::string& name) : AbsentSensor(name, "Receiver") {}
  /// Absent here: 0. Simulator: Number of packets received and not removed.
  int getQueueLength() const { return 0; }
  /// Absent here: no effect. Simulator: removes the first packet.
  virtual void nextPacket() {}
  /// Absent here: NULL. Simulator: data of the first packet, getDataSize() bytes.
  const void* getData() const { return 0; }
  /// Absent here: 0. Simulator: size of the first packet in bytes.
  int getDataSize() const { return 0; }
  /// Absent here: NaN. Simulator: strength of the first packet, 1 / (distance in m)^2; no unit.
  double getSignalStrength() const { return darwinop::webots_api::absentNumber(); }
  /// Absent here: NaN. Simulator: direction of the sender of the first packet, a unit vector, components -1 to 1.
  const double* getEmitterDirection() const { return darwinop::webots_api::absentNumbers(); }
  /// Absent here: no effect. Simulator: channel from here on, -1 to 2147483647.
  virtual void setChannel(int /*channel*/) {}
  /// Absent here: -1. Simulator: channel, -1 to 2147483647.
  int getChannel() const { return -1; }
};

}  // namespace webots

#endif
