// Target and speed of a page's first step from the present pose.
#pragma once

#include "core/conversions.hpp"
#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// rad/s, mean over a first step. Under the robot's weight a servo reaches about half of its no-load speed.
inline constexpr double kFastestFirstStep = kNoLoadSpeed / 2;

/// Target of the first step; joints that are not part of it keep `present`.
inline Pose firstTarget(const Page& page, const Pose& present) {
  Pose target = present;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::uint16_t word = page.step.front().position.at(i + 1);  // by servo id
    if ((word & (kKeep | kTorqueOff)) == 0) target[i] = std::min<int>(word, kTickMax);
  }
  return target;
}

/// rad/s, mean speed of the joint with the longest distance. `page` must be playable.
inline double firstStepSpeed(const Page& page, const Pose& present) {
  const Pose target = firstTarget(page, present);
  int distance = 0;
  for (std::size_t i = 0; i < kJoints; ++i) distance = std::max(distance, std::abs(target[i] - present[i]));
  const int scaled = std::max(1, (page.step.front().time * page.speed) >> 5);
  const int ticks = page.schedule == kTimeBased ? scaled : std::max(1, 40 * distance / (3 * scaled));
  return distance * kRadPerTick / (ticks * kTickMs / 1000.0);
}

}  // namespace darwinop::motion
