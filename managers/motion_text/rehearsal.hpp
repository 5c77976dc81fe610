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

/// A page and those that follow it, played from a pose.
struct Rehearsal {
  struct Section {
    int page = 0;
    std::size_t begin = 0;           // index in poses
    std::vector<std::size_t> steps;  // where its steps begin, in every repetition
  };
  std::vector<Pose> poses;  // every 8 ms, the first one is where it began
  std::vector<Section> sections;
  bool cut = false;  // it would go on: a ring of pages, or longer than a minute
};

/// In a ring each page is played once. The page can be played.
[[nodiscard]] Rehearsal rehearse(const PageFile& pages, int page, const Pose& from);

}  // namespace darwinop::motion
