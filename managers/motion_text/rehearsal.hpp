// Plays one page by itself, as the robot's engine does, to see how long it takes and how fast the joints must be.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// Where a page begins: the pose of its first step, for nobody knows where the robot comes from. A joint that has
/// no part in that step is where a later step first sends it.
[[nodiscard]] Pose firstPose(const Page& page);

/// Of all repetitions together, in ticks of 8 ms; the pages before and after are not part of it. A page by speed has
/// a first step that takes longer the farther the robot is from it: this is the least.
[[nodiscard]] int ticksOf(const PageFile& pages, int page);

/// How far the goal of each joint moves in one tick at most, in servo ticks.
struct StepSpeeds {
  int page = 0;
  std::size_t step = 0;  // from 0
  std::array<int, kJoints> most{};
};

/// The page's steps from its first pose, the first one again when it repeats, and the first step of the page that
/// follows.
[[nodiscard]] std::vector<StepSpeeds> rehearse(const PageFile& pages, int page);

}  // namespace darwinop::motion
