#include "gap/identify/body/floor_search.hpp"

#include <algorithm>
#include <cmath>

#include "gap/identify/body/floor_start.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// What an effect pays for its numbers (Schwarz); one that is chosen from a list, for the length of the list.
double priceOf(const FloorEffect& effect, double samples) {
  const auto is_fixed = [](const FloorEffect::Number& number) { return number.is_fixed; };
  if (std::ranges::all_of(effect.numbers, is_fixed)) return 2 * std::log(static_cast<double>(effect.starts.size()));
  return static_cast<double>(effect.numbers.size()) * std::log(samples);
}

/// The last effect at another strength: its numbers before `end`; those behind at neutral.
FloorSet atStrength(FloorSet set, double strength, std::size_t end) {
  PlacedFloor& last = set.back();
  for (std::size_t i = 0; i < last.values.size(); ++i) {
    const FloorEffect::Number& number = last.effect->numbers[i];
    const double neutral = last.effect->neutral[i], share = number.is_fixed ? 1 : i < end ? strength : 0;
    last.values[i] = std::clamp(neutral + share * (last.values[i] - neutral), number.low, number.high);
  }
  return set;
}

/// Walks are chaotic: the cost has many minima, and derivatives lead into the nearest. Goes on from a better variation.
FloorFit outOfValley(FloorEvaluator& evaluator, FloorFit fit) {
  for (int round = 0; round < thresholds::kFloorValleys; ++round) {
    const std::vector<FloorSet> sets = variationsOf(fit.set);
    const std::vector<Eigen::VectorXd> residuals = evaluator.residuals(sets);
    std::size_t best = 0;
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (costOf(sets[i], residuals[i]) < costOf(sets[best], residuals[best])) best = i;
    if (!(costOf(sets[best], residuals[best]) < fit.cost)) break;
    fit = fitFloor(evaluator, sets[best], thresholds::kFloorIterations);
  }
  return fit;
}

}  // namespace

void widenByEqualFits(FloorFit& best, const std::vector<FloorFit>& fits) {
  for (const FloorFit& other : fits) {
    if (other.cost > best.cost * (1 + thresholds::kFloorChaos)) continue;
    for (std::size_t i = 0; i < best.set.size(); ++i)
      for (std::size_t k = 0; k < best.set[i].values.size(); ++k)
        best.sigmas[i][k] = std::max(best.sigmas[i][k], std::abs(other.set[i].values[k] - best.set[i].values[k]));
  }
}

FloorFit refined(FloorEvaluator& evaluator, const FloorSet& found) {
  std::vector<FloorFit> fits{fitFloor(evaluator, found, thresholds::kFloorIterations)};
  for (const double strength : thresholds::kFloorSides)
    fits.push_back(
        fitFloor(evaluator, atStrength(found, strength, found.back().values.size()), thresholds::kFloorIterations));
  FloorFit best = *std::ranges::min_element(fits, {}, &FloorFit::cost);
  widenByEqualFits(best, fits);
  return best;
}

// A place of a mass means nothing without the mass, so that what is at neutral are the vectors behind the first.
std::vector<FloorSet> variationsOf(const FloorSet& set) {
  const PlacedFloor& last = set.back();
  const std::vector<FloorEffect::Number>& numbers = last.effect->numbers;
  std::vector<std::size_t> ends;  // of the first vector, and of all
  for (std::size_t i = 1; i <= numbers.size(); ++i)
    if (i == numbers.size() || (ends.empty() && numbers[i].key != numbers[0].key)) ends.push_back(i);
  std::vector<FloorSet> out;
  for (const std::size_t end : ends)
    for (const double strength : thresholds::kFloorStrengths) out.push_back(atStrength(set, strength, end));
  return out;
}

std::vector<FloorCandidate> nextFloorEffects(FloorEvaluator& evaluator, const std::vector<const FloorEffect*>& effects,
                                             const FloorSet& found, double base_cost) {
  std::vector<FloorCandidate> simulated, sensed;
  for (const FloorEffect* const effect : effects) {
    if (std::ranges::find(found, effect, &PlacedFloor::effect) != found.end()) continue;
    FloorStart start = bestStart(evaluator, found, *effect);
    FloorCandidate one{.fit = {.set = std::move(start.set), .sigmas = {}}, .start_cost = start.cost};
    (effect->is_of_sensor ? sensed : simulated).push_back(std::move(one));
  }
  std::ranges::stable_sort(simulated, {}, &FloorCandidate::start_cost);
  if (simulated.size() > thresholds::kFittedFloor) simulated.resize(thresholds::kFittedFloor);
  std::vector<FloorCandidate> all = std::move(simulated);
  for (FloorCandidate& one : sensed) all.push_back(std::move(one));
  const double noise = static_cast<double>(evaluator.size()) * thresholds::kFloorCostOfNoise;
  double best_cost = base_cost;
  const auto isFarBehind = [&](double cost, double times) {
    return cost - noise > times * std::max(thresholds::kMechanicsShare * noise, best_cost - noise);
  };
  std::ranges::stable_sort(all, {}, &FloorCandidate::start_cost);
  // A rival that stays far behind is not searched to its end, nor any where all leave too much.
  for (FloorCandidate& one : all) {
    const bool is_hopeless = isFarBehind(one.start_cost, thresholds::kFloorStartFarBehind);
    one.fit = fitFloor(evaluator, std::move(one.fit.set), is_hopeless ? 0 : thresholds::kFloorRivalIterations);
    best_cost = std::min(best_cost, one.fit.cost);
  }
  const bool is_worth_it = base_cost - best_cost > thresholds::kFloorShare * (base_cost - noise);
  for (FloorCandidate& one : all) {
    if (is_worth_it && !isFarBehind(one.fit.cost, thresholds::kFloorFarBehind))
      one.fit = outOfValley(evaluator, fitFloor(evaluator, std::move(one.fit.set), thresholds::kFloorIterations));
    best_cost = std::min(best_cost, one.fit.cost);
    // What no model explains is not noise of independent samples.
    const double samples = static_cast<double>(evaluator.size()) / thresholds::kCorrelatedSamples;
    const double scale =
        thresholds::kCorrelatedSamples * std::max(1.0, one.fit.cost / static_cast<double>(evaluator.size()));
    const PlacedFloor& last = one.fit.set.back();
    const double gain = (base_cost - one.fit.cost) / scale;
    const double price = priceOf(*last.effect, samples) + 2 * std::log(static_cast<double>(effects.size()));
    one.evidence = gain - price;
    one.name_evidence = std::min(gain, last.costAmongEngines()) - price;
  }
  std::ranges::stable_sort(all, std::greater{}, &FloorCandidate::evidence);
  return all;
}

}  // namespace darwinop::gap
