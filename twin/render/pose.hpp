// Generalized coordinates of the twin at one instant: all that rendering needs.
#pragma once

#include <array>
#include <cstddef>

namespace darwinop::twin {

class RobotBody;

/// Trivially copyable, for a ring buffer or a file.
struct Pose {
  static constexpr std::size_t kMaxCoordinates = 48;  // 20 joints and four free bodies
  double time_s = 0;
  std::array<double, kMaxCoordinates> qpos{};  // in MuJoCo's order; the first `nq` are used
};

/// Call between two steps of the body. Allocates nothing.
Pose poseOf(RobotBody& body) noexcept;

}  // namespace darwinop::twin
