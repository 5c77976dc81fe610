#include "gap/benchmark/body/poses.hpp"

#include <algorithm>

namespace darwinop::gap {

Goals goalsOf(const MirroredPose& pose) {
  const std::array right{pose.shoulder,  pose.arm_upper, pose.arm_lower, pose.pelvis_yaw, pose.pelvis,
                         pose.leg_upper, pose.leg_lower, pose.ankle,     pose.foot};
  Goals out{};
  for (std::size_t i = 0; i < right.size(); ++i) out[2 * i] = right[i], out[2 * i + 1] = -right[i];
  out[static_cast<std::size_t>(Joint::kNeck)] = pose.neck, out[static_cast<std::size_t>(Joint::kHead)] = pose.head;
  return out;
}

double ramp(double time_s, double over_s) {
  const double x = std::clamp(time_s / over_s, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

}  // namespace darwinop::gap
