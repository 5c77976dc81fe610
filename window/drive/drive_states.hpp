// States of the drive thread as a pure function.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::window {

enum class DriveState : std::uint8_t {
  kFree,      // no session
  kStarting,  // acquiring the lease, then waiting for torque
  kDriving,   // executes requests
  kEnding,    // completes the present steps, then stands
  kHolding,   // the robot holds; the lease is being given back
  kCount
};
inline constexpr std::size_t kDriveStates = static_cast<std::size_t>(DriveState::kCount);
inline constexpr std::array<std::string_view, kDriveStates> kDriveStateNames{"free", "starting", "driving", "ending",
                                                                             "holding"};

enum class DriveEvent : std::uint8_t {
  kStartAsked,
  kTorqueOn,        // the robot follows the commands
  kRequestsMissed,  // no request for too long
  kFinishAsked,     // hold after the present steps
  kStopAsked,       // hold at once
  kStands,          // the steps are completed, or have taken too long
  kFailed,          // torque did not come on, or the robot has ended the session
  kReleased,        // the lease is given back, or could not be acquired
  kCount
};
inline constexpr std::size_t kDriveEvents = static_cast<std::size_t>(DriveEvent::kCount);
inline constexpr std::array<std::string_view, kDriveEvents> kDriveEventNames{
    "start_asked", "torque_on", "requests_missed", "finish_asked", "stop_asked", "stands", "failed", "released"};

/// The state after `event` in `state`.
constexpr DriveState next(DriveState state, DriveEvent event) {
  using enum DriveState;
  switch (event) {
    case DriveEvent::kStartAsked:
      return state == kFree ? kStarting : state;
    case DriveEvent::kTorqueOn:
      return state == kStarting ? kDriving : state;
    case DriveEvent::kRequestsMissed:
      return state == kDriving ? kEnding : state;
    case DriveEvent::kFinishAsked:
      if (state == kStarting) return kHolding;  // no steps to complete
      return state == kDriving ? kEnding : state;
    case DriveEvent::kStands:
      return state == kEnding ? kHolding : state;
    case DriveEvent::kStopAsked:
    case DriveEvent::kFailed:
      return state == kFree ? state : kHolding;
    case DriveEvent::kReleased:
      return kFree;
    case DriveEvent::kCount:
      break;
  }
  return state;
}

static_assert(next(DriveState::kHolding, DriveEvent::kTorqueOn) == DriveState::kHolding, "a stop is final");

}  // namespace darwinop::window
