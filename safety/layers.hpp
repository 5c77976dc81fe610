// Two files of settings, one above the other: the robot's own (robot.ini) and a controller's (config.ini).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "safety/config.hpp"

namespace darwinop::safety {

/// Who wins when both files name a setting. What is not listed is the controller's.
enum class Stricter : std::uint8_t { kLower, kHigher, kMode };
struct StricterRow {
  std::string_view name;
  Stricter wins;
};
// What guards the robot: a controller can make it stricter than the robot's owner did, never laxer.
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

/// Of a setting that robot and controller both name, as numbers. What is not listed above is the controller's.
[[nodiscard]] double stricter(std::string_view name, double robot, double controller) noexcept;

/// Every setting as a number, choices too: [Safety] in the order of visit(), then low and high of each joint.
std::vector<double> numbers(const Config& config);

struct Layer {
  const Config& config;
  std::string file;  // for the sentences
};

/// The settings that hold. A setting that one file names is that file's; of one that both name, see kStricterWins.
/// Ranges of joints are what both allow. Throws std::runtime_error, with both files, when nothing is left of a
/// range or when the settings contradict each other.
Config layered(const Layer& robot, const Layer& controller);

}  // namespace darwinop::safety
