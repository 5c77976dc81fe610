#include "gap/identify/body/mechanics_selection.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/controller_selection.hpp"
#include "gap/identify/body/declared_numbers.hpp"
#include "gap/identify/body/held_out_motion.hpp"
#include "gap/identify/body/log_agreement.hpp"
#include "gap/identify/body/mechanics_entry.hpp"
#include "gap/identify/body/mechanics_screen.hpp"
#include "gap/localize/body/close_by_numbers.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Cost beyond that of a right model, in each limb.
std::vector<double> excessOf(const ClampedRobot& robot, const BodyHypothesis& hypothesis) {
  std::vector<double> out(robot.limbs().size());
  forEach(out.size(), [&](std::size_t limb) {
    const auto samples = static_cast<double>(robot.residuals(limb).size()) / 2;  // loads cost next to nothing
    out[limb] = std::max(0.0, costOf(robot, {limb}, hypothesis) - samples);
  });
  return out;
}

/// Fitted candidates of the next effect, best first.
std::vector<MechanicsEntry> nextEffects(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                        const std::vector<std::size_t>& open, const std::vector<double>& excess) {
  const std::vector<PlacedMechanics> now = effectsOf(found);
  if (open.size() == robot.limbs().size()) {
    std::vector<MechanicsEntry> common =
        fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAllJoints));
    double sum = 0;
    for (const double one : excess) sum += one;
    if (!common.empty() && common.front().gain > thresholds::kExplainedGapShare * sum) return common;
  }
  return fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAny));
}

double sumOver(const std::vector<std::size_t>& limbs, const std::vector<double>& of) {
  double sum = 0;
  for (const std::size_t limb : limbs) sum += of[limb];
  return sum;
}

bool sharesLimb(const ClampedRobot& robot, const PlacedMechanics& effect, const std::vector<std::size_t>& limbs) {
  return std::ranges::any_of(limbsOf(robot, {effect}),
                             [&](std::size_t own) { return std::ranges::find(limbs, own) != limbs.end(); });
}

/// Estimates the noise about what was found, and fits all numbers in the limbs of the last effect together.
void refit(ClampedRobot& robot, std::vector<FoundMechanics>& found) {
  const std::vector<std::size_t> touched = limbsOf(robot, {found.back().placed});
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].is_in_controller) continue;  // a motion that is not quite right must not move what loads show directly
    if (sharesLimb(robot, found[i].placed, touched)) free.push_back(i);
  }
  robot.renew(touched, with(robot, effectsOf(found)));
  const MechanicsFit all = fitMechanics(robot, effectsOf(found), free, false, thresholds::kMechanicsIterations);
  for (const std::size_t i : free) found[i].placed = all.effects[i], found[i].sigmas = all.sigmas[i];
}

/// Drops the effects in limbs that are still open which have not removed most of what they found there.
void dropUnexplained(const ClampedRobot& robot, double open_from, MechanicsSelection& selection) {
  const std::vector<double> after = excessOf(robot, with(robot, effectsOf(selection.found)));
  const std::vector<std::size_t> open = openLimbs(robot, selection.rows, open_from);
  const auto isExplained = [&](const FoundMechanics& one) {
    return one.is_in_controller || !sharesLimb(robot, one.placed, open) ||
           sumOver(limbsOf(robot, {one.placed}), after) < (1 - thresholds::kExplainedGapShare) * one.excess_before;
  };
  std::vector<FoundMechanics> kept;
  for (FoundMechanics& one : selection.found) {
    if (isExplained(one))
      kept.push_back(std::move(one));
    else
      selection.tried.push_back(std::move(one.placed));
  }
  selection.found = std::move(kept);
}

}  // namespace

MechanicsSelection identifyMechanics(ClampedRobot& robot, const BodyTable& table) {
  MechanicsSelection out;
  out.found = identifyControllers(robot.given(), robot.baseline(), table.open_from);
  if (!robot.isTestable()) return out;
  if (!out.found.empty()) robot.renew(limbsOf(robot, effectsOf(out.found)), with(robot, effectsOf(out.found)));
  const double threshold = -2 * std::log(thresholds::kMechanicalChance);
  const std::vector<double> before = excessOf(robot, robot.baseline());
  std::vector<PlacedMechanics> numbers;  // effects that are numbers of the model within their priors
  // Limbs whose residuals are new may be off within their priors.
  const auto renewRows = [&](const std::vector<std::size_t>& limbs) {
    for (const PlacedMechanics& one : numbers)
      if (sharesLimb(robot, one, limbs)) moveNumbers(robot, one, with(robot, effectsOf(out.found)));
    closeByNumbers(robot, limbs, with(robot, effectsOf(out.found)), table.open_from);
    out.rows = mechanicsRows(robot, with(robot, effectsOf(out.found)));
    for (BodyRow& row : out.rows) row.open = row.significance > table.open_from;
  };
  renewRows(limbsOf(robot, effectsOf(out.found)));
  while (out.found.size() < thresholds::kMostMechanics) {
    const std::vector<std::size_t> open = openLimbs(robot, out.rows, table.open_from);
    if (open.empty()) break;
    const std::vector<double> excess = excessOf(robot, with(robot, effectsOf(out.found)));
    std::vector<MechanicsEntry> entries = nextEffects(robot, out.found, open, excess);
    if (entries.empty()) break;
    const MechanicsEntry& best = entries.front();
    FoundMechanics one{.placed = best.fit.effects.back(), .sigmas = {}, .rivals = {}, .gain = best.gain};
    const std::vector<std::size_t> limbs = limbsOf(robot, {one.placed});
    one.excess_before = sumOver(limbs, excess);
    const double share = std::max(thresholds::kMechanicsShare * sumOver(limbs, excess),
                                  thresholds::kMechanicsRemainder * sumOver(limbs, before));
    const double needed = std::max(threshold, share);
    if (best.evidence < needed) break;
    if (best.evidence - std::max(0.0, best.gain - priorCost(robot, one.placed)) < needed) {
      if (std::ranges::any_of(numbers, [&](const auto& number) { return number.sameName(one.placed); })) break;
      numbers.push_back(std::move(one.placed));
      renewRows(limbs);
      continue;
    }
    one.rivals = rivalsOf(entries);
    const std::vector<FoundMechanics> without = out.found;
    const double unseen = heldOutError(robot, with(robot, effectsOf(without)));
    out.found.push_back(std::move(one));
    refit(robot, out.found);
    const BodyHypothesis before_it = with(robot, effectsOf(without)), with_it = with(robot, effectsOf(out.found));
    if (anyLogRefutes(robot, limbs, before_it, with_it) ||
        heldOutError(robot, with_it) > thresholds::kHeldOutRise * unseen) {
      out.tried.push_back(out.found.back().placed);
      out.found = without;
      robot.renew(limbs, with(robot, effectsOf(without)));
      renewRows(limbs);
      break;
    }
    renewRows(limbs);
  }
  const std::size_t count = out.found.size();
  dropUnexplained(robot, table.open_from, out);
  if (out.found.size() < count) renewRows({});
  out.held_out_before = heldOutError(robot, robot.baseline());
  out.held_out_after = heldOutError(robot, with(robot, effectsOf(out.found)));
  out.held_out_floor = kEncoderNoise;
  return out;
}

}  // namespace darwinop::gap
