#include "gap/localize/body/close_by_numbers.hpp"

#include <algorithm>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

bool isLimbOpen(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& hypothesis, double open_from) {
  return std::ranges::any_of(limbRows(robot, limb, hypothesis),
                             [&](const BodyRow& row) { return row.significance > open_from; });
}

/// Where to begin. Where a limp arm falls depends on every number, and not even nearly linearly: the other logs first.
std::unique_ptr<LimbResiduals> beginningOf(const LimbResiduals& given, const BodyHypothesis& hypothesis) {
  std::unique_ptr<LimbResiduals> held = given.withoutReleases(hypothesis);
  if (held == nullptr) return nullptr;
  for (int step = 0; step < thresholds::kNumberSteps; ++step) {
    std::optional<Eigen::VectorXd> numbers = held->betterNumbers(hypothesis);
    if (!numbers) break;
    held = held->about(hypothesis, std::move(*numbers));
  }
  return given.about(hypothesis, held->numbers());
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
    if (std::unique_ptr<LimbResiduals> beginning = beginningOf(robot.residuals(limb), hypothesis))
      before = robot.replace(limb, std::move(beginning));
    for (int step = 0; step < thresholds::kNumberSteps && isLimbOpen(robot, limb, hypothesis, open_from); ++step) {
      const LimbResiduals& now = robot.residuals(limb);
      std::optional<Eigen::VectorXd> numbers = now.betterNumbers(hypothesis);
      if (!numbers) break;
      std::unique_ptr<LimbResiduals> old = robot.replace(limb, now.about(hypothesis, std::move(*numbers)));
      if (before == nullptr) before = std::move(old);
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
