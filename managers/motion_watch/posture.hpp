// How the body is, by its accelerometer and its knees: standing, sitting, lying.
#pragma once

#include <string_view>

#include "core/sensors.hpp"

namespace darwinop::motion {

enum class Posture : std::uint8_t { kUnknown, kStands, kSits, kOnFace, kOnBack, kOnRight, kOnLeft, kUpsideDown };

/// A robot at rest: the accelerometer shows where up is. Upright with knees bent by 90 degrees or more it sits or
/// kneels; with unknown knees it is taken for standing. Unknown: no accelerometer, or the robot is being moved.
[[nodiscard]] Posture postureOf(const Sensors& sensors);

/// "stands", "lies on its face": what stands behind "the robot".
[[nodiscard]] std::string_view textOf(Posture posture);

}  // namespace darwinop::motion
