// The start pose (sitting), and the check whether the robot is close enough to it to be moved there safely.
#pragma once

#include <array>
#include <string>

#include "core/joints.hpp"
#include "core/sensors.hpp"
#include "core/units.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// Start pose of the joint table, clamped to the configured limits.
[[nodiscard]] std::array<Rad, kJoints> startPose(const Config& config) noexcept;

// Thresholds of the robot's original software: 230 ticks (20.2 deg) for leg joints, g/4 for each axis of the trunk.
// Arms and head are not checked: they are light and do not collide on the way.
inline constexpr double kStartPoseTolerance = 230 * kRadPerTick;
inline constexpr double kOrientationTolerance = kGravity / 4;  // m/s2
inline constexpr std::array<double, 3> kUpright{0, 0, kGravity};

// Parts of describe(): after a joint's name, and at the start of the line about the trunk.
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
  bool without_board = false;  // nothing measures the acceleration

  /// Without a board, which robot.ini has to say, the joints alone decide: such a robot would never start by itself.
  [[nodiscard]] bool secure() const noexcept { return off_count == 0 && (upright || without_board); }
};

/// Checks readings of the last few cycles against the start pose of the robot's configuration; older or missing
/// readings count as unknown and fail.
[[nodiscard]] StartPoseCheck checkStartPose(const Sensors& seen,
                                            const std::array<Rad, kJoints>& start = startPose(Config{})) noexcept;

/// Text for the user: one line for each joint that is off, with its deviation, and one for the orientation. Not for the
/// loop.
[[nodiscard]] std::string describe(const StartPoseCheck& check);

}  // namespace darwinop::safety
