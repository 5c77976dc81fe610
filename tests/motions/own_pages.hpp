// Our own pages as one file of pages, and the two poses that they promise to end in.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/conversions.hpp"
#include "managers/gait/goals.hpp"
#include "managers/motion/player.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {

/// Throws std::runtime_error for a text that cannot be read, and for a page that two of them have.
inline PageFile ownPages() {
  PageFile all;
  for (std::size_t i = 0; i < kPages; ++i) all.push_back(unmentionedPage(i));
  for (const auto& entry : std::filesystem::directory_iterator{DARWINOP_MOTIONS}) {
    if (entry.path().extension() != ".txt") continue;
    const PageFile one = readMotionFile(entry.path()).pages;
    for (std::size_t i = 1; i < kPages; ++i) {
      if (!one[i].canPlay()) continue;
      if (all[i].canPlay()) throw std::runtime_error{entry.path().string() + ": another file has its page, too"};
      all[i] = one[i];
    }
  }
  return all;
}

/// The stance in which walking begins; the head looks ahead.
inline Pose stance() {
  Pose pose{};
  std::ranges::copy(gait::kStanding.tick, pose.begin());
  pose[index(Joint::kNeck)] = kTickCentre;
  pose[index(Joint::kHead)] = row(Joint::kHead).start;
  return pose;
}

/// The start pose: a robot rests in it without its servos.
inline Pose sitting() {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = kJointTable[i].start;
  return pose;
}

/// Of the last step.
inline Pose lastPose(const Page& page) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = page.step[page.steps - 1U].position[i + 1];
  return pose;
}

}  // namespace darwinop::motion
