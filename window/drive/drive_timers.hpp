// Time limits of a drive session, in robot time. Pure.
#pragma once

#include <optional>

#include "window/drive/drive_states.hpp"

namespace darwinop::window {

class DriveTimers {
 public:
  static constexpr double kTakeoverMs = 30'000;  // ms for torque to come on
  static constexpr double kSettleMs = 300;       // ms after the last step, so that joints arrive before they are held
  static constexpr double kLongestEndMs = 6000;  // ms for the last steps and the stance

  /// Event of this cycle in `state`. `drives`: the robot follows the commands. `walks`: it makes steps. `ms`: time
  /// since the last call.
  [[nodiscard]] std::optional<DriveEvent> advance(DriveState state, bool drives, bool walks, double ms) {
    if (state != state_) in_state_ms_ = 0;
    state_ = state;
    in_state_ms_ += ms;
    if (walks) settling_ms_ = kSettleMs;
    if (state == DriveState::kStarting) {
      if (drives) return DriveEvent::kTorqueOn;
      if (in_state_ms_ > kTakeoverMs) return DriveEvent::kFailed;
    } else if (state == DriveState::kEnding) {
      if (!walks) settling_ms_ -= ms;
      if (settling_ms_ <= 0 || in_state_ms_ > kLongestEndMs) return DriveEvent::kStands;
    }
    return std::nullopt;
  }

 private:
  DriveState state_ = DriveState::kFree;
  double in_state_ms_ = 0;
  double settling_ms_ = 0;  // left until the joints have settled
};

}  // namespace darwinop::window
