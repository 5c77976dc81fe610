// How the twin stands at one instant: all that is needed to draw it, and little enough to be copied often.
#pragma once

#include <array>
#include <cstddef>

namespace darwinop::twin {

class RobotBody;

/// Plain memory, so that it can go through a ring or a file.
struct Pose {
  static constexpr std::size_t kMost = 48;  // twenty joints and four bodies that move freely
  double time_s = 0;
  std::array<double, kMost> qpos{};  // as MuJoCo orders it; the model knows how many count
};

/// Between two steps of the body. Allocates nothing.
Pose poseOf(RobotBody& body) noexcept;

}  // namespace darwinop::twin
