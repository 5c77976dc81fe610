// Posture from accelerometer and knee angles: standing, sitting, lying.
#pragma once

#include <string_view>

#include "core/sensors.hpp"

namespace darwinop::motion {

enum class Posture : std::uint8_t { kUnknown, kStands, kSits, kOnFace, kOnBack, kOnRight, kOnLeft, kUpsideDown };

/// For a robot at rest. Upright with knees bent by 90 degrees or more: sits or kneels; with unknown knees: stands.
/// Unknown without an accelerometer or while the robot is moved.
[[nodiscard]] Posture postureOf(const Sensors& sensors);

/// Text after "the robot": "stands", "lies on its face".
[[nodiscard]] std::string_view textOf(Posture posture);

}  // namespace darwinop::motion
