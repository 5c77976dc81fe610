// [Safety] and [Limits] of a controller's session, as part of its commands.
#pragma once

#include <cstdint>

#include "core/commands.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// As numbers, for the command image.
[[nodiscard]] SessionSettings toSession(const Config& config);

/// Inverse of toSession(); `named` as Config::named. A number out of range becomes the default.
[[nodiscard]] Config fromSession(const SessionSettings& settings, std::uint32_t named);

/// The robot's settings for a session with settings `asked`. Joint ranges are intersected; of settings in kStricterWins
/// the stricter value is used; all others are the session's. The input comes from another process: a number that is not
/// finite or out of range, an empty range, and contradictory settings leave the robot's own. Called in the loop: no
/// heap, no exception.
[[nodiscard]] Config tightened(const Config& robot, const SessionSettings& asked) noexcept;

}  // namespace darwinop::safety
