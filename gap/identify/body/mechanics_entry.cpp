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

}  // namespace

double priceOf(const ClampedRobot& robot, const PlacedMechanics& placed, std::size_t numbers) {
  return namePrice(placed) + static_cast<double>(numbers) * numberPrice(robot, limbsOf(robot, {placed}));
}

MechanicsEntry fittedFrom(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                          const PlacedMechanics& start) {
  std::vector<PlacedMechanics> effects = effectsOf(found);
  effects.push_back(start);
  const double before = costOf(robot, limbsOf(robot, {start}), with(robot, effectsOf(found)));
  MechanicsEntry entry;
  entry.fit = fitMechanics(robot, effects, {effects.size() - 1}, false, thresholds::kMechanicsIterations);
  entry.gain = before - entry.fit.cost;
  entry.evidence = entry.gain - priceOf(robot, start, entry.fit.numbers);
  return entry;
}

std::vector<std::size_t> bestOfLimbs(const ClampedRobot& robot, const std::vector<MechanicsEntry>& entries) {
  std::vector<std::size_t> out, seen;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::vector<std::size_t> limbs = limbsOf(robot, {entries[i].placed()});
    const auto is_new = [&](std::size_t limb) { return std::ranges::find(seen, limb) == seen.end(); };
    if (std::ranges::any_of(limbs, is_new)) out.push_back(i);
    seen.insert(seen.end(), limbs.begin(), limbs.end());
  }
  return out;
}

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

void setOwn(BodyHypothesis robot, std::vector<FoundMechanics>& found) {
  for (FoundMechanics& one : found) {
    if (one.placed.effect->numbers.front().is_addition) {
      for (const Joint joint : one.placed.joints) one.own.push_back(ownNumber(robot, *one.placed.effect, joint));
      one.placed.values.front() = std::max(one.placed.values.front(), -std::ranges::max(one.own));
    }
    one.placed.applyTo(robot);
  }
}

bool isInOneOf(const ClampedRobot& robot, const PlacedMechanics& effect, const std::vector<std::size_t>& limbs) {
  return std::ranges::any_of(limbsOf(robot, {effect}),
                             [&](std::size_t own) { return std::ranges::find(limbs, own) != limbs.end(); });
}

double namePrice(const PlacedMechanics& placed) {
  const double effects = static_cast<double>(mechanicalEffects().size());
  double places = kJoints;
  if (placed.joints.size() == 2) places = kJoints / 2 - 1;
  if (placed.joints.size() == kJoints) places = 1;
  return 2 * std::log(effects * places);
}

std::vector<MechanicsCandidate> shortlist(const ClampedRobot& robot, std::vector<MechanicsCandidate> candidates) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const PlacedMechanics& placed = candidates[i].placed;
    order.emplace_back(candidates[i].predicted_gain - priceOf(robot, placed, freeNumbers(*placed.effect)), i);
  }
  std::ranges::stable_sort(order, std::greater{}, &std::pair<double, std::size_t>::first);
  std::vector<MechanicsCandidate> out;
  std::vector<std::size_t> of_limb(robot.limbs().size());
  for (const auto& [evidence, i] : order) {
    const PlacedMechanics& placed = candidates[i].placed;
    if (std::ranges::any_of(out, [&](const auto& other) { return sameLink(other.placed, placed); })) continue;
    const std::vector<std::size_t> limbs = limbsOf(robot, {placed});
    const auto has_few = [&](std::size_t limb) { return of_limb[limb] < thresholds::kFittedOfLimb; };
    if (out.size() >= thresholds::kFittedMechanics && std::ranges::none_of(limbs, has_few)) continue;
    for (const std::size_t limb : limbs) ++of_limb[limb];
    out.push_back(std::move(candidates[i]));
  }
  return out;
}

std::vector<MechanicsEntry> fitted(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                   const std::vector<MechanicsCandidate>& candidates) {
  const std::vector<MechanicsCandidate> chosen = shortlist(robot, candidates);
  std::vector<MechanicsEntry> out(chosen.size());
  forEach(chosen.size(), [&](std::size_t i) { out[i] = fittedFrom(robot, found, chosen[i].placed); });
  std::ranges::stable_sort(out, std::greater{}, &MechanicsEntry::evidence);
  for (const std::size_t i : bestOfLimbs(robot, out)) {
    const PlacedMechanics best = out[i].placed();
    if (!best.effect->is_of_link) continue;
    const std::size_t count = out.size();
    for (const MechanicsCandidate& other : candidates)
      if (sameLink(other.placed, best)) out.push_back(fittedFrom(robot, found, other.placed));
    // Where the mass itself hardly shows, the linear screen puts it far off: it also starts at the centre of mass.
    const auto from_centre = [&](MechanicsEntry& one) {
      PlacedMechanics start = one.placed();
      if (start.effect->numbers.front().unit != "kg") return;
      start.values.assign(start.values.size(), 0.0);
      start.values.front() = start.effect->numbers.front().typical;
      MechanicsEntry other = fittedFrom(robot, found, start);
      if (other.evidence > one.evidence) one = std::move(other);
    };
    from_centre(out[i]);
    for (std::size_t k = count; k < out.size(); ++k) from_centre(out[k]);
  }
  std::ranges::stable_sort(out, std::greater{}, &MechanicsEntry::evidence);
  return out;
}

std::vector<PlacedMechanics> rivalsOf(const std::vector<MechanicsEntry>& entries) {
  const MechanicsEntry& best = entries.front();
  const PlacedMechanics& name = best.placed();
  std::vector<PlacedMechanics> rivals;
  for (const MechanicsEntry& rival : entries) {
    const PlacedMechanics& other = rival.placed();
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
