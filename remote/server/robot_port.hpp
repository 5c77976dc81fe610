// What the server needs of a robot: a lease, somebody who obeys, the newest sensors.
#pragma once

#include <cstdint>
#include <string>

#include "core/sensors.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

enum class Beginning : std::uint8_t {
  kFresh,  // a new client: the robot begins as with a new controller
  kAgain   // the same one after a silence: from where the robot is, and what it had said still holds
};

/// Used by one thread. Nothing here waits for the robot.
class RobotPort {
 public:
  virtual ~RobotPort() = default;

  /// Takes the driving lease. Throws std::runtime_error with what to do when that cannot be.
  virtual void begin(Beginning beginning) = 0;

  /// Gives the lease back as if begin() had not been.
  virtual void leaveAlone() noexcept {}

  /// Carries out a request's LEDs and motors. Between begin() and hold() only, as all that follows.
  virtual void obey(const Request& request) = 0;

  /// The newest image.
  [[nodiscard]] virtual Sensors sensors() = 0;

  /// A sentence when whoever drives has to end, as after torque was switched off by hand; else empty.
  [[nodiscard]] virtual std::string mustEnd() = 0;

  /// Motion is held where it is, the lease is given back.
  virtual void hold() noexcept = 0;

  /// Instead of hold(), for who ends tidily: safety does what [Safety] on_exit asks for.
  virtual void farewell() noexcept { hold(); }

  /// False in simulated time, where cycles run when they are asked for.
  [[nodiscard]] virtual bool realTime() const { return true; }
};

}  // namespace darwinop::remote
