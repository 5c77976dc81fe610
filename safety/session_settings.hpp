// [Safety] and [Limits] that travel with a controller's session and make the robot's own stricter.
#pragma once

#include <cstdint>

#include "core/commands.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// As numbers, for the command image.
[[nodiscard]] SessionSettings toSession(const Config& config);

/// Back to settings; `named` as Config::named. Of a number out of its range the default holds.
[[nodiscard]] Config fromSession(const SessionSettings& settings, std::uint32_t named);

/// The robot's settings for a session that asks for `asked`. Ranges of joints become what both allow; of the settings
/// in kStricterWins the stricter one holds; all others are the session's. A number that is not finite or out of its
/// range, a range that leaves nothing, and settings that contradict each other leave the robot's own: the image comes
/// from another process. Called in the loop: no heap, no exception.
[[nodiscard]] Config tightened(const Config& robot, const SessionSettings& asked) noexcept;

}  // namespace darwinop::safety
