// Computes joint goals in servo ticks from feet, legs and arms.
#pragma once

#include <array>
#include <optional>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/poses.hpp"
#include "managers/gait/leg.hpp"

namespace darwinop::gait {

/// Joints used for walking, ids 1..18: all but the head.
inline constexpr std::size_t kWalkingJoints = 18;

/// Goals in ticks, index: servo id - 1.
struct Goals {
  std::array<int, kWalkingJoints> tick{};

  int& operator[](Joint joint) { return tick[index(joint)]; }
  int operator[](Joint joint) const { return tick[index(joint)]; }
  /// rad; rounds to exactly this tick.
  [[nodiscard]] double rad(std::size_t joint) const { return radFromTicks(tick[joint]).value; }
};

/// Standing with the default parameters: the engine at rest.
inline constexpr Goals kStanding = [] {
  Goals goals;
  for (std::size_t i = 0; i < kWalkingJoints; ++i) goals.tick[i] = kWalkReadyTicks[i];
  return goals;
}();

/// Empty if a foot is out of reach.
std::optional<Goals> goalsFor(const Feet& feet, const Parameters& parameters);

/// Clamps to the joint ranges, as the safety layer would.
void clampToJoints(Goals& goals);

/// P gain register of a joint while walking. Source: the ROBOTIS engine, with compliant arms.
double pGain(Joint joint, const Parameters& parameters);

}  // namespace darwinop::gait
