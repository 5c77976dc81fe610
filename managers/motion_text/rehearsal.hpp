// Goes through one page by itself: how long it takes, and how far each step moves the joints.
#pragma once

#include <array>
#include <vector>

#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// Where a page begins: the pose of its first step, for nobody knows where the robot comes from. A joint that has
/// no part in that step is where a later step first sends it.
[[nodiscard]] Pose firstPose(const Page& page);

/// Of all repetitions together, in ticks of 8 ms; the pages before and after are not part of it. A page by speed has
/// a first step that takes longer the farther the robot is from it: this is the least.
[[nodiscard]] int ticksOf(const PageFile& pages, int page);

struct Move {
  int page = 0;
  std::size_t step = 0;                 // from 0
  int ticks = 0;                        // of 8 ms, without the pause
  std::array<int, kJoints> distance{};  // servo ticks, never negative
};

/// The page's steps from its first pose, the first one again when it repeats, and the first step of the page that
/// follows.
[[nodiscard]] std::vector<Move> movesOf(const PageFile& pages, int page);

}  // namespace darwinop::motion
