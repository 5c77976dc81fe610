// Simulates pages without a robot: durations, and distances of each step.
#pragma once

#include <array>
#include <vector>

#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// Assumed initial pose of a page: the pose of its first step. A joint that is not part of that step has its first
/// target in a later step.
[[nodiscard]] Pose firstPose(const Page& page);

/// Duration of all repetitions, in ticks of 8 ms, without other pages. The first step of a page by speed takes longer
/// if the robot is farther away: this is the minimum.
[[nodiscard]] int ticksOf(const PageFile& pages, int page);

struct Move {
  int page = 0;
  std::size_t step = 0;                 // from 0
  int ticks = 0;                        // of 8 ms, without the pause
  std::array<int, kJoints> distance{};  // servo ticks, absolute
};

/// The page's steps from its first pose, the first step again if it repeats, and the first step of the next page.
[[nodiscard]] std::vector<Move> movesOf(const PageFile& pages, int page);

/// A page and its successors, played from a pose.
struct DryRun {
  struct Section {
    int page = 0;
    std::size_t begin = 0;           // index in poses
    std::vector<std::size_t> steps;  // indices of its steps, in every repetition
  };
  std::vector<Pose> poses;  // every 8 ms, starting with the initial pose
  std::vector<Section> sections;
  bool cut = false;  // truncated: an endless chain, or longer than a minute
};

/// In an endless chain each page is played once. `page` must be playable.
[[nodiscard]] DryRun dryRun(const PageFile& pages, int page, const Pose& from);

}  // namespace darwinop::motion
