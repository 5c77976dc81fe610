// The first step of a page, seen from where the robot is: where to, and how fast.
#pragma once

#include "core/conversions.hpp"
#include "managers/motion/player.hpp"

namespace darwinop::motion {

// Source: MX-28 data sheet, 55 rpm without a load at 12 V: 5.760 rad/s.
inline constexpr double kNoLoadSpeed = 55 * 2 * kPi / 60;
/// rad/s, mean over a first step. What carries a robot's weight does about half of its speed without a load.
inline constexpr double kFastestFirstStep = kNoLoadSpeed / 2;

/// Where it sends joints that are at `present`; those that have no part in it stay.
inline Pose firstTarget(const Page& page, const Pose& present) {
  Pose target = present;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::uint16_t word = page.step.front().position.at(i + 1);  // by servo id
    if ((word & (kKeep | kTorqueOff)) == 0) target[i] = std::min<int>(word, kTickMax);
  }
  return target;
}

/// rad/s, of the joint with the longest way, mean over the move. `page` can be played.
inline double firstStepSpeed(const Page& page, const Pose& present) {
  const Pose target = firstTarget(page, present);
  int way = 0;
  for (std::size_t i = 0; i < kJoints; ++i) way = std::max(way, std::abs(target[i] - present[i]));
  const int scaled = std::max(1, (page.step.front().time * page.speed) >> 5);
  const int ticks = page.schedule == kTimeBased ? scaled : std::max(1, 40 * way / (3 * scaled));
  return way * kRadPerTick / (ticks * kTickMs / 1000.0);
}

}  // namespace darwinop::motion
