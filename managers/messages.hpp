// Messages of the managers, or the parts that identify them.
#pragma once

#include <cmath>
#include <string>

namespace managers::messages {

inline constexpr const char* kRobotIsNull = "the robot is null";
inline constexpr const char* kWalksWithoutBalance =
    "balance is off: the gyroscope was not calibrated, because the robot was moved, the gyroscope does not reply, or "
    "the walk began with setBalanceEnable(false). Keep the robot still for a second before start(), "
    "and call setBalanceEnable(true) before it";
inline constexpr const char* kNoGyroscope = "balance is off: this robot has no gyroscope";

// Of a walk or a page, after what it is.
inline constexpr const char* kNotFollowed = " ends: the robot has not followed for 0.3 s";
inline constexpr const char* kWalksAgain =
    ". Unless stop() is called, it starts again from the robot's pose as soon as the robot follows";

// Of setParameters().
inline constexpr const char* kParametersRefused = "setParameters() changes nothing: ";
inline constexpr const char* kNotInitialized = "the manager is not initialized";

// After a damaged page of a motion file.
inline constexpr const char* kPageIsRefused = "; this page is refused, the others are kept";

// Of a loop slower than its step.
inline constexpr const char* kTooSlow = "the controller is slower than its step: a round takes ";
inline constexpr const char* kDeclare = "; declare what fits, here and in Robot::step() (time_step in config.ini): ";

/// `round_ms`: measured mean; `step_ms`: declared.
inline std::string tooSlow(double round_ms, int step_ms) {
  constexpr double kTick = 8, kMeasured = 0.5;  // ms
  const double fits_ms = std::ceil((round_ms - kMeasured) / kTick) * kTick;
  return kTooSlow + std::to_string(std::lround(round_ms)) + " ms, and step(" + std::to_string(step_ms) +
         ") declares less. The walk keeps the robot's time up to 80 ms a round" + kDeclare + "step(" +
         std::to_string(std::lround(fits_ms)) + ")";
}

}  // namespace managers::messages
