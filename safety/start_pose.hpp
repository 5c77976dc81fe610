// The start pose (sitting), and the check whether a robot is near enough to it to be moved there safely.
#pragma once

#include <array>
#include <string>

#include "core/joints.hpp"
#include "core/sensors.hpp"
#include "core/units.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// Start pose of the joint table, within the configured limits.
[[nodiscard]] std::array<Rad, kJoints> startPose(const Config& config) noexcept;

// Thresholds of the check that came with the robot: 230 ticks (20.2 deg) for leg joints, a quarter of a g in
// each axis of the trunk. Arms and head are not checked: they are light and hit nothing on their way.
inline constexpr double kStartPoseTolerance = 230 * kRadPerTick;
inline constexpr double kOrientationTolerance = kGravity / 4;  // m/s2
inline constexpr std::array<double, 3> kUpright{0, 0, kGravity};

// Parts of describe(): of a joint after its name, and the first words about the trunk.
inline constexpr const char* kPositionUnknown = "position not known";
inline constexpr const char* kOrientationUnknown = "orientation not known";
inline constexpr const char* kNotUpright = "not upright";

struct StartPoseCheck {
  struct JointOff {
    Joint joint{};
    Rad position;  // NaN: not known
    Rad start;
    double off_rad = 0;  // position - start; NaN: not known
  };
  std::array<JointOff, kJoints> off{};  // the first `off_count` are valid
  std::size_t off_count = 0;
  std::array<MeterPerSec2, 3> acceleration{};  // as measured; NaN: not known
  bool upright = false;

  [[nodiscard]] bool secure() const noexcept { return off_count == 0 && upright; }
};

/// Judges readings of the last few cycles; what is older, or was never read, is not known and fails.
[[nodiscard]] StartPoseCheck checkStartPose(const Sensors& seen) noexcept;

/// One line for each joint that is off, with its name and by how much, and one for the orientation. For people;
/// never called in the loop.
[[nodiscard]] std::string describe(const StartPoseCheck& check);

}  // namespace darwinop::safety
