#include "gap/identify/body/mechanics_entry.hpp"

#include <algorithm>
#include <cmath>

#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Of a free number (Schwarz 1978), for the samples of a joint.
double numberPrice(const ClampedRobot& robot, const std::vector<std::size_t>& limbs) {
  double samples = 0;
  for (const std::size_t limb : limbs)
    samples += static_cast<double>(robot.residuals(limb).size()) / static_cast<double>(2 * robot.limbs()[limb].size());
  return std::log(std::max(2.0, samples));
}

MechanicsEntry fittedFrom(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                          const PlacedMechanics& start) {
  std::vector<PlacedMechanics> effects = effectsOf(found);
  effects.push_back(start);
  const std::vector<std::size_t> limbs = limbsOf(robot, {start});
  const double before = costOf(robot, limbs, with(robot, effectsOf(found)));
  MechanicsEntry entry;
  entry.fit = fitMechanics(robot, effects, {effects.size() - 1}, false, thresholds::kMechanicsIterations);
  entry.gain = before - entry.fit.cost;
  entry.evidence = entry.gain - namePrice(start) - static_cast<double>(entry.fit.numbers) * numberPrice(robot, limbs);
  return entry;
}

}  // namespace

double costOf(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& hypothesis) {
  double sum = 0;
  for (const std::size_t limb : limbs) sum += robustCost(robot.residuals(limb).of(hypothesis));
  return sum;
}

std::vector<PlacedMechanics> effectsOf(const std::vector<FoundMechanics>& found) {
  std::vector<PlacedMechanics> out;
  for (const FoundMechanics& one : found) out.push_back(one.placed);
  return out;
}

double namePrice(const PlacedMechanics& placed) {
  const double effects = static_cast<double>(mechanicalEffects().size());
  double places = kJoints;
  if (placed.joints.size() == 2) places = kJoints / 2 - 1;
  if (placed.joints.size() == kJoints) places = 1;
  return 2 * std::log(effects * places);
}

std::vector<MechanicsEntry> fitted(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                   const std::vector<MechanicsCandidate>& candidates) {
  const std::size_t count = std::min(candidates.size(), thresholds::kFittedMechanics);
  std::vector<MechanicsEntry> out(count);
  forEach(count, [&](std::size_t i) { out[i] = fittedFrom(robot, found, candidates[i].placed); });
  std::ranges::stable_sort(out, std::greater{}, &MechanicsEntry::evidence);
  if (out.empty()) return out;
  const PlacedMechanics best = out.front().fit.effects.back();
  for (std::size_t i = count; i < candidates.size(); ++i)
    if (sameLink(candidates[i].placed, best)) out.push_back(fittedFrom(robot, found, candidates[i].placed));
  // Where the mass itself hardly shows, the linear screen puts it far off: it also starts at the centre of mass.
  for (MechanicsEntry& one : out) {
    PlacedMechanics start = one.fit.effects.back();
    if (!start.effect->is_of_link || start.effect->numbers.front().unit != "kg" || start.joints != best.joints)
      continue;
    start.values.assign(start.values.size(), 0.0);
    start.values.front() = start.effect->numbers.front().typical;
    MechanicsEntry other = fittedFrom(robot, found, start);
    if (other.evidence > one.evidence) one = std::move(other);
  }
  std::ranges::stable_sort(out, std::greater{}, &MechanicsEntry::evidence);
  return out;
}

std::vector<PlacedMechanics> rivalsOf(const std::vector<MechanicsEntry>& entries) {
  const MechanicsEntry& best = entries.front();
  const PlacedMechanics& name = best.fit.effects.back();
  std::vector<PlacedMechanics> rivals;
  for (const MechanicsEntry& rival : entries) {
    const PlacedMechanics& other = rival.fit.effects.back();
    if (other.sameName(name)) continue;
    // Where recordings show the first moment alone, a mass at some point and a shift differ by numbers that only their
    // priors determine: these have no price.
    if (sameLink(other, name) && best.gain - rival.gain < thresholds::kRivalEvidence)
      rivals.insert(rivals.begin(), other);
    else if (best.evidence - rival.evidence < thresholds::kRivalEvidence)
      rivals.push_back(other);
  }
  if (name.effect->is_of_link && rivals.size() > thresholds::kMostLinkRivals)
    rivals.resize(thresholds::kMostLinkRivals);
  return rivals;
}

}  // namespace darwinop::gap
