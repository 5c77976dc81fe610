#include "gap/identify/body/unexplained_mechanics.hpp"

#include <algorithm>

#include "gap/identify/body/mechanics_entry.hpp"
#include "gap/localize/body/close_by_numbers.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::vector<double> excessOf(const ClampedRobot& robot, const BodyHypothesis& hypothesis) {
  std::vector<double> out(robot.limbs().size());
  forEach(out.size(), [&](std::size_t limb) {
    const auto samples = static_cast<double>(robot.residuals(limb).size()) / 2;  // loads cost next to nothing
    out[limb] = std::max(0.0, costOf(robot, {limb}, hypothesis) - samples);
  });
  return out;
}

double sumOver(const std::vector<std::size_t>& limbs, const std::vector<double>& of) {
  double sum = 0;
  for (const std::size_t limb : limbs) sum += of[limb];
  return sum;
}

void dropUnexplained(const ClampedRobot& robot, double open_from, MechanicsSelection& selection) {
  const std::vector<double> after = excessOf(robot, with(robot, effectsOf(selection.found)));
  const std::vector<std::size_t> open = openLimbs(robot, selection.rows, open_from);
  const auto isExplained = [&](std::size_t i) {
    const FoundMechanics& one = selection.found[i];
    return one.is_in_controller || !isInOneOf(robot, one.placed, open) ||
           sumOver(limbsOf(robot, {one.placed}), after) < (1 - thresholds::kExplainedGapShare) * one.excess_before;
  };
  std::vector<bool> is_kept(selection.found.size());
  for (std::size_t i = 0; i < is_kept.size(); ++i) is_kept[i] = isExplained(i);
  std::vector<FoundMechanics> kept;
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    if (is_kept[i])
      kept.push_back(std::move(selection.found[i]));
    else
      selection.tried.push_back(std::move(selection.found[i].placed));
  }
  selection.found = std::move(kept);
}

}  // namespace darwinop::gap
