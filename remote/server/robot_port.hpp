// Interface between server and robot: sessions, commands, sensors.
#pragma once

#include <cstdint>
#include <string>

#include "core/sensors.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

enum class SessionStart : std::uint8_t {
  kNew,     // a new client: as for a new controller
  kResumed  // the same client after a silence: from the present position, with its earlier commands
};

/// Not thread-safe. No call waits for the robot.
class RobotPort {
 public:
  virtual ~RobotPort() = default;

  /// Takes the driving lease. Throws std::runtime_error with the remedy.
  virtual void startSession(SessionStart start) = 0;

  /// Gives the lease back without any command to the robot.
  virtual void cancelSession() noexcept {}

  /// Applies the LEDs and motors of a request. This and the following calls require an open session.
  virtual void apply(const Request& request) = 0;

  /// The newest image.
  [[nodiscard]] virtual Sensors sensors() = 0;

  /// Why the session must end, for example after torque was switched off by hand; otherwise empty.
  [[nodiscard]] virtual std::string endReason() = 0;

  /// Why the robot's loop ends soon: a client may finish its last steps, until endReason() is not empty. Otherwise
  /// empty. Call endReason() first.
  [[nodiscard]] virtual std::string endRequest() { return {}; }

  /// Holds the present position and gives the lease back.
  virtual void hold() noexcept = 0;

  /// Instead of hold(), for a client that ends normally: safety does what [Safety] on_exit requests.
  virtual void endSession() noexcept { hold(); }

  /// False in simulated time, where cycles run on request.
  [[nodiscard]] virtual bool realTime() const { return true; }
};

}  // namespace darwinop::remote
