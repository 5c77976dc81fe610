// Takes the place of a controller that was given up: holds the robot as it is, with red lights.
#pragma once

#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "runtime/daemon_link.hpp"

namespace darwinop::supervisor {

/// Red on head and panel: somebody should look at the robot.
[[nodiscard]] LedCommand redLights();

class Holder {
 public:
  /// Takes the driving lease. Throws std::runtime_error when somebody else drives or no daemon runs.
  explicit Holder(const runtime::RuntimeFiles& files);
  /// Says farewell: the robot sits down and lets go.
  ~Holder() = default;

  /// At least ten times a second; safety takes a driver that is silent for longer for a stalled one. False: the loop is
  /// gone, or a fault that waits for a person has ended it; whyEnded() tells.
  bool hold();
  [[nodiscard]] const std::string& whyEnded() const { return why_ended_; }

 private:
  runtime::DaemonLink link_;
  Commands commands_;
  std::string why_ended_;
};

/// Of a program, which clears no latched fault. No goals: a joint that is under torque stays where it is, and one that
/// is limp stays limp.
[[nodiscard]] Commands asItIs(const Sensors& seen);

}  // namespace darwinop::supervisor
