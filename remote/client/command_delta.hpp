// What a controller wants, as the wire says it: each wish once, when it changes.
#pragma once

#include <array>
#include <cstdint>

#include "core/commands.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

/// Remembers what a server has been told. The server keeps it as long as the connection lasts.
class Wishes {
 public:
  /// Adds what differs from what was told before. Values are rounded to the wire's units, which are those of the
  /// servos: the robot gets the tick that it would have got without a network.
  void add(const Commands& wanted, Request& request);

  /// For a server that knows nothing yet.
  void forget() { *this = {}; }

 private:
  void addLeds(const LedCommand& wanted, Request& request);

  std::array<MotorSetting, kJoints> told_{};
  LedCommand led_{};
};

}  // namespace darwinop::remote
