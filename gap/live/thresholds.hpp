// Constants of the live comparison, with their evidence.
#pragma once

#include <cstdint>

#include "core/sensors.hpp"
#include "core/units.hpp"

namespace darwinop::gap::live {

/// s over which rms values run: as long as the recordings of `darwinop gap record`, which hold 4.4 s of motion each.
inline constexpr double kWindow = 5;

/// s after the twin was put into the measured pose, not compared. Limits of speed and torque are known only after a
/// round of polls, at most 1 s (core/sensors.hpp); a twin put beside a moving joint has caught up by then: 4 periods of
/// the slowest servo loop, 0.2 s (LiveComparison.CatchesUpWithAMovingJoint).
inline constexpr double kSettle = 1;

/// Cycles in a row that may be missing. Goals of missing cycles are unknown, so the twin holds the last ones. The same
/// patience as safety has with a silent board.
inline constexpr std::uint64_t kMostMissing = kAnswerPatience;

/// s, time constant of the direction of gravity. Longer than a step of the gait (0.6 s): its accelerations average out.
inline constexpr double kGravityTime = 0.7;

/// rad. A trunk this near to one of the six directions along its axes is taken to be exactly there, as in a stand of
/// `darwinop gap record`; farther away than any error of mounting (`darwinop calibrate` accepts 0.17), nearer than
/// half of the way to the next.
inline constexpr double kAlongAxis = 0.2;

/// rad between its direction and the last reading below which a turned trunk is at rest again: half of the above.
inline constexpr double kSteady = kAlongAxis / 2;

/// rad between the trunk's directions of robot and twin, for this time: one of them has fallen or was turned. Gait and
/// our motion pages lean less than 0.3 rad from the twin's own lean.
inline constexpr double kTurned = 0.5, kTurnedFor = 0.5;

/// s before that moment that count as not compared: the turn was noticed after kTurnedFor and the delay of the
/// direction (0.3 s for a right angle), and a fall takes up to 1 s.
inline constexpr double kTurning = kTurnedFor + 2 * kGravityTime;

}  // namespace darwinop::gap::live
