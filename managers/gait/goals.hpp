// Joint goals in servo ticks, from feet, legs and arms.
#pragma once

#include <array>
#include <optional>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "managers/gait/leg.hpp"

namespace darwinop::gait {

/// Joints that walk, ids 1..18: all but the head.
inline constexpr std::size_t kWalkingJoints = 18;

/// Goals by id minus one, in ticks.
struct Goals {
  std::array<int, kWalkingJoints> tick{};

  int& operator[](Joint joint) { return tick[index(joint)]; }
  int operator[](Joint joint) const { return tick[index(joint)]; }
  /// rad, the nearest to which is exactly this tick again.
  [[nodiscard]] double rad(std::size_t joint) const { return radFromTicks(tick[joint]).value; }
};

/// Standing with the default parameters. Source: the engine at rest, equal to page 9, "walkready", of the motion file.
inline constexpr Goals kStanding{
    {1498, 2518, 1845, 2248, 2381, 1712, 2048, 2048, 2052, 2044, 1637, 2459, 2653, 1443, 2389, 1707, 2057, 2039}};

/// Nothing: a foot is out of reach.
std::optional<Goals> goalsFor(const Feet& feet, const Parameters& parameters);

/// Into the range of every joint: beyond it, safety would do the same.
void clampToJoints(Goals& goals);

/// P gain register of a joint while walking. Source: the ROBOTIS engine, which lets the arms swing softly.
double pGain(Joint joint, const Parameters& parameters);

}  // namespace darwinop::gait
