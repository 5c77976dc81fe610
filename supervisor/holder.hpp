// Holds the robot in its pose, with red lights, after the default controller has failed.
#pragma once

#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "runtime/driver_session.hpp"
#include "runtime/names.hpp"

namespace darwinop::supervisor {

/// Red on head and panel: user action needed.
[[nodiscard]] LedCommand redLights();

class Holder {
 public:
  /// Acquires the lease. Throws std::runtime_error if another process drives or no daemon runs.
  explicit Holder(const runtime::RuntimeFiles& files);
  /// Ends the session: the robot sits down and torque goes off.
  ~Holder() = default;

  /// Call at least ten times a second; a driver that is silent for longer counts as stalled. Returns false if the loop
  /// is gone or a fault has ended the session; see whyEnded().
  bool hold();
  [[nodiscard]] const std::string& whyEnded() const { return why_ended_; }

 private:
  runtime::DriverSession session_;
  Commands commands_;
  std::string why_ended_;
};

/// As an unattended session, which clears no latched fault. Without goals: joints under torque keep their position,
/// limp joints stay limp.
[[nodiscard]] Commands asItIs(const Sensors& seen);

}  // namespace darwinop::supervisor
