// Merges the settings of two files: the robot's (robot.ini) and a controller's (config.ini).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "safety/config.hpp"

namespace darwinop::safety {

/// Which value wins if both files set one. For settings not listed: the controller's.
enum class Stricter : std::uint8_t { kLower, kHigher, kMode };
struct StricterRow {
  std::string_view name;
  Stricter wins;
};
// Settings that protect the robot: a controller can make them stricter than robot.ini, never laxer.
inline constexpr auto kStricterWins = std::to_array<StricterRow>({
    {"max_joint_speed", Stricter::kLower},
    {"gentle_speed", Stricter::kLower},
    {"battery_low", Stricter::kHigher},
    {"battery_empty", Stricter::kHigher},
    {"hot", Stricter::kLower},
    {"overheat", Stricter::kLower},
    {"release_button", Stricter::kMode},
});
static_assert(static_cast<int>(ReleaseButton::kMode) < static_cast<int>(ReleaseButton::kNone));

/// The value that wins for setting `name`, which both files set.
[[nodiscard]] double stricter(std::string_view name, double robot, double controller) noexcept;

/// Every setting as a number (choices as their index): [Safety] in the order of visit(), then low and high of each
/// joint.
std::vector<double> numbers(const Config& config);

struct Layer {
  const Config& config;
  std::string file;  // for error messages
};

/// The effective settings. A setting in one file is taken from it; for one in both files see kStricterWins. Joint
/// ranges are intersected. Throws std::runtime_error with both files if a range becomes empty or settings contradict
/// each other.
Config layered(const Layer& robot, const Layer& controller);

}  // namespace darwinop::safety
