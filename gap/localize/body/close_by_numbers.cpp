#include "gap/localize/body/close_by_numbers.hpp"

#include <algorithm>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

bool isLimbOpen(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& hypothesis, double open_from) {
  return std::ranges::any_of(limbRows(robot, limb, hypothesis),
                             [&](const BodyRow& row) { return row.significance > open_from; });
}

}  // namespace

std::vector<std::size_t> openLimbs(const ClampedRobot& robot, const std::vector<BodyRow>& rows, double open_from) {
  std::vector<std::size_t> out;
  std::size_t row = 0;
  for (std::size_t limb = 0; limb < robot.limbs().size(); ++limb) {
    bool is_open = false;
    for (std::size_t joint = 0; joint < robot.limbs()[limb].size(); ++joint, ++row)
      is_open = is_open || rows[row].significance > open_from;
    if (is_open) out.push_back(limb);
  }
  return out;
}

bool closeByNumbers(ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& hypothesis,
                    double open_from) {
  bool has_closed = false;
  if (!robot.isTestable()) return has_closed;
  for (const std::size_t limb : limbs) {
    if (!isLimbOpen(robot, limb, hypothesis, open_from)) continue;
    std::unique_ptr<LimbResiduals> before;
    for (int step = 0; step < thresholds::kNumberSteps; ++step) {
      const LimbResiduals& now = robot.residuals(limb);
      std::optional<Eigen::VectorXd> numbers = now.betterNumbers(hypothesis);
      if (!numbers) break;
      std::unique_ptr<LimbResiduals> old = robot.replace(limb, now.about(hypothesis, std::move(*numbers)));
      if (before == nullptr) before = std::move(old);
      if (!isLimbOpen(robot, limb, hypothesis, open_from)) break;
    }
    if (before == nullptr) continue;
    if (isLimbOpen(robot, limb, hypothesis, open_from))
      robot.replace(limb, std::move(before));
    else
      has_closed = true;
  }
  return has_closed;
}

}  // namespace darwinop::gap
