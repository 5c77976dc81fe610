// Copies the pose of the body.
#include "twin/render/pose.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>

#include "twin/body/robot_body.hpp"

namespace darwinop::twin {

Pose poseOf(RobotBody& body) noexcept {
  Pose pose;
  pose.time_s = body.time_s();
  const auto count = std::min(static_cast<std::size_t>(body.mujocoModel()->nq), Pose::kMaxCoordinates);
  std::copy_n(body.mujocoData()->qpos, count, pose.qpos.begin());
  return pose;
}

}  // namespace darwinop::twin
