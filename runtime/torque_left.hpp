// Joints that may still be under torque when a loop ends.
#pragma once

#include <bitset>
#include <string>

#include "core/sensors.hpp"

namespace darwinop::runtime {

using JointSet = std::bitset<kJoints>;

/// Servos that have answered since the loop started.
[[nodiscard]] JointSet everAnswered(const Sensors& seen) noexcept;

/// Of the servos in `present`, those whose last poll found torque, and those whose torque is unknown: not polled for
/// two rounds, or the board is silent. None if the board reports that servo power is off.
[[nodiscard]] JointSet perhapsUnderTorque(const Sensors& seen, const JointSet& present) noexcept;

/// "Neck, LegLowerR"; "all joints".
[[nodiscard]] std::string namesOf(const JointSet& joints);

}  // namespace darwinop::runtime
