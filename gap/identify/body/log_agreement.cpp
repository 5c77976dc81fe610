#include "gap/identify/body/log_agreement.hpp"

#include <algorithm>
#include <map>

#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

bool refutes(const LogGain& log) {
  return log.change > thresholds::kDecidingChange && log.gain < -log.change / 2;
}

bool supports(const LogGain& log) {
  return log.change > thresholds::kDecidingChange && log.gain > log.change / 2;
}

namespace {

LogGain gainIn(const LimbResiduals& residuals, const BodyHypothesis& without, const BodyHypothesis& with) {
  const Eigen::VectorXd before = residuals.of(without), after = residuals.of(with);
  return {robustCost(before) - robustCost(after), (after - before).squaredNorm()};
}

}  // namespace

LogGain gainOf(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without, const BodyHypothesis& with) {
  return gainIn(robot.residuals(limb), without, with);
}

LogGain heldOutGain(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without,
                    const BodyHypothesis& with) {
  const std::vector<std::size_t> logs = clampedLogs(robot.given(), true);
  if (logs.empty()) return {};
  return gainIn(LimbResiduals{robot.given(), logs, robot.limbs()[limb], robot.residuals(limb).withNumbers(with)},
                robot.residuals(limb).withNumbers(without), robot.residuals(limb).withNumbers(with));
}

bool anyLogRefutes(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& without,
                   const BodyHypothesis& with) {
  std::map<std::size_t, LogGain> logs;
  for (const std::size_t limb : limbs) {
    const LimbResiduals& residuals = robot.residuals(limb);
    const Eigen::VectorXd before = residuals.of(without), after = residuals.of(with);
    Eigen::Index at = 0;
    for (const LimbSamples& block : residuals.blocks()) {
      const Eigen::VectorXd from = before.segment(at, block.rows), to = after.segment(at, block.rows);
      at += block.rows;
      LogGain& log = logs[block.log];
      log.gain += robustCost(from) - robustCost(to), log.change += (to - from).squaredNorm();
    }
  }
  return std::ranges::any_of(logs, [](const auto& one) { return refutes(one.second); });
}

}  // namespace darwinop::gap
