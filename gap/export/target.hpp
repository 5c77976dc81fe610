// Simulators that a model can be written for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace darwinop::gap {

enum class Target : std::uint8_t { kWebots, kMujoco, kUrdf };
inline constexpr std::size_t kTargets = 3;

struct TargetInfo {
  Target target;
  std::string_view word;  // on a command line: "webots"
  std::string_view title;
  double step_s;  // usual time step
};
inline constexpr std::array<TargetInfo, kTargets> kTargetTable{{
    {Target::kWebots, "webots", "Webots", 0.016},  // least that the robot's own controller loop accepts
    {Target::kMujoco, "mujoco", "MuJoCo", 0.002},  // MuJoCo's default
    {Target::kUrdf, "urdf", "URDF", 0.001},        // of the programs that usually read it
}};

constexpr const TargetInfo& infoOf(Target target) {
  return kTargetTable[static_cast<std::size_t>(target)];
}

constexpr std::optional<Target> targetFrom(std::string_view word) {
  for (const TargetInfo& info : kTargetTable)
    if (info.word == word) return info.target;
  return std::nullopt;
}

}  // namespace darwinop::gap
