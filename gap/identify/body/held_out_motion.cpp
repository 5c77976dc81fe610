#include "gap/identify/body/held_out_motion.hpp"

#include <cmath>
#include <numeric>

#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

namespace {

struct Squares {
  double sum = 0, count = 0;
};

Squares squaresIn(const ClampedRobot& robot, std::size_t of_limb, const BodyHypothesis& hypothesis) {
  const Limb& limb = robot.limbs()[of_limb];
  Squares out;
  for (const std::size_t log : clampedLogs(robot.given(), true)) {
    const LimbTrace trace = rollOut(robot.given(), log, limb, hypothesis);
    for (std::size_t joint = 0; joint < limb.size(); ++joint) {
      const Trajectory& rows = robot.given().joint(log, static_cast<std::size_t>(limb[joint].joint));
      for (std::size_t row = 0; row < rows.rows(); ++row) {
        if (std::isnan(rows.position_rad[row])) continue;
        const double error = rows.position_rad[row] -
                             trace.position_rad(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(joint));
        out.sum += error * error, out.count += 1;
      }
    }
  }
  return out;
}

std::vector<std::size_t> allLimbs(const ClampedRobot& robot) {
  std::vector<std::size_t> out(robot.limbs().size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

}  // namespace

double heldOutError(const ClampedRobot& robot, const BodyHypothesis& hypothesis) {
  return heldOutErrorIn(robot, allLimbs(robot), hypothesis);
}

double heldOutErrorIn(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                      const BodyHypothesis& hypothesis) {
  std::vector<Squares> of(limbs.size());
  forEach(limbs.size(), [&](std::size_t i) {
    of[i] = squaresIn(robot, limbs[i], robot.residuals(limbs[i]).withNumbers(hypothesis));
  });
  Squares all;
  for (const Squares& one : of) all.sum += one.sum, all.count += one.count;
  return std::sqrt(all.sum / all.count);
}

bool holdsUnseen(double before_rad, double after_rad) {
  return std::isnan(before_rad) || after_rad <= thresholds::kHeldOutRise * before_rad;
}

}  // namespace darwinop::gap
