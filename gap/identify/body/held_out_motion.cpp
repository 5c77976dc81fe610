#include "gap/identify/body/held_out_motion.hpp"

#include <cmath>

namespace darwinop::gap {

double heldOutError(const ClampedRobot& robot, const BodyHypothesis& hypothesis) {
  double square = 0, count = 0;
  for (const std::size_t log : clampedLogs(robot.given(), true))
    for (const Limb& limb : robot.limbs()) {
      const LimbTrace trace = rollOut(robot.given(), log, limb, hypothesis);
      for (std::size_t joint = 0; joint < limb.size(); ++joint) {
        const Trajectory& rows = robot.given().joint(log, static_cast<std::size_t>(limb[joint].joint));
        for (std::size_t row = 0; row < rows.rows(); ++row) {
          if (std::isnan(rows.position_rad[row])) continue;
          const double error = rows.position_rad[row] -
                               trace.position_rad(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(joint));
          square += error * error, count += 1;
        }
      }
    }
  return std::sqrt(square / count);
}

}  // namespace darwinop::gap
