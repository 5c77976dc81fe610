// Computes joint goals in servo ticks from feet, legs and arms.
#pragma once

#include <array>
#include <optional>

#include "core/conversions.hpp"
#include "core/joints.hpp"
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

/// Standing with the default parameters. Source: the engine at rest, equal to page 9, "walkready", of the motion file.
inline constexpr Goals kStanding{
    {1498, 2518, 1845, 2248, 2381, 1712, 2048, 2048, 2052, 2044, 1637, 2459, 2653, 1443, 2389, 1707, 2057, 2039}};

/// Empty if a foot is out of reach.
std::optional<Goals> goalsFor(const Feet& feet, const Parameters& parameters);

/// Clamps to the joint ranges, as the safety layer would.
void clampToJoints(Goals& goals);

/// P gain register of a joint while walking. Source: the ROBOTIS engine, with compliant arms.
double pGain(Joint joint, const Parameters& parameters);

}  // namespace darwinop::gait
