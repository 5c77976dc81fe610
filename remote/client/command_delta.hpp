// Converts commands to requests: each command once, when it changes.
#pragma once

#include <array>
#include <cstdint>

#include "core/commands.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

/// Stores what has been sent on a connection; the server keeps it until the connection ends.
class CommandDelta {
 public:
  /// Adds the commands that differ from those sent before. Values are rounded to the wire's units, those of the servos,
  /// so
  /// the robot gets the same tick as without a network.
  void add(const Commands& wanted, Request& request);

  /// For a new connection.
  void forget() { *this = {}; }

 private:
  void addLeds(const LedCommand& wanted, Request& request);

  std::array<MotorSetting, kJoints> sent_{};
  LedCommand led_{};
};

}  // namespace darwinop::remote
