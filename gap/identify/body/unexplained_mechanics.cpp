#include "gap/identify/body/unexplained_mechanics.hpp"

#include <algorithm>

#include "gap/identify/body/held_out_motion.hpp"
#include "gap/identify/body/log_agreement.hpp"
#include "gap/identify/body/mechanics_entry.hpp"
#include "gap/localize/body/close_by_numbers.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/registers.hpp"
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

namespace {

/// The held-out logs support the effect: in each of its limbs, with a small remainder there; or in at least kLimbsOfAll
/// limbs, whatever the remainder, with none that refutes it.
bool isShownByHeldOut(const ClampedRobot& robot, const std::vector<FoundMechanics>& found, std::size_t one) {
  const std::vector<PlacedMechanics> all = effectsOf(found);
  std::vector<PlacedMechanics> others = all;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(one));
  const BodyHypothesis without = with(robot, others), with_it = with(robot, all);
  const std::vector<std::size_t> limbs = limbsOf(robot, {all[one]});
  const double small = thresholds::kSmallRemainder * readingSigma(with_it.servos.servo);
  const bool is_small = heldOutErrorIn(robot, limbs, with_it) <= small;
  if (!is_small && limbs.size() < thresholds::kLimbsOfAll) return false;
  std::vector<LogGain> gains(limbs.size());
  forEach(limbs.size(), [&](std::size_t i) { gains[i] = heldOutGain(robot, limbs[i], without, with_it); });
  const auto showing = static_cast<std::size_t>(std::ranges::count_if(gains, supports));
  return showing == limbs.size() || (showing >= thresholds::kLimbsOfAll && std::ranges::none_of(gains, refutes));
}

}  // namespace

void dropUnexplained(const ClampedRobot& robot, double open_from, MechanicsSelection& selection) {
  const std::vector<double> after = excessOf(robot, with(robot, effectsOf(selection.found)));
  const std::vector<std::size_t> open = openLimbs(robot, selection.rows, open_from);
  const auto isExplained = [&](std::size_t i) {
    const FoundMechanics& one = selection.found[i];
    return one.is_in_controller || !isInOneOf(robot, one.placed, open) ||
           sumOver(limbsOf(robot, {one.placed}), after) < (1 - thresholds::kExplainedGapShare) * one.excess_before ||
           isShownByHeldOut(robot, selection.found, i);
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
