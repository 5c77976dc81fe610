// Limits of torque and speed that a controller asked a servo for. One that acts and is not simulated would be taken for
// an effect of the robot.
#pragma once

#include <string>

#include "core/joints.hpp"
#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kTorqueLimitActs =
    "limits the load, and torque limits are not simulated; cut there with from_s and to_s, or record without";
inline constexpr const char* kSpeedLimitChanges =
    "changes and limits the motion, which is not simulated; cut there with from_s and to_s, or record with one limit";
}  // namespace messages

/// The servo's own speed limit, rad/s; 0: none that is known, or one that changes.
double speedLimitOf(const logs::Log& recording, Joint joint);

/// Throws BadInput, a sentence with column and line, for the first row in which a limit of torque acts, or one of speed
/// that changes. `rows`: the joint's, filled.
void refuseActiveLimits(const logs::Log& recording, Joint joint, const Trajectory& rows);

}  // namespace darwinop::gap
