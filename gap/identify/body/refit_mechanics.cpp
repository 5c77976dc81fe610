#include "gap/identify/body/refit_mechanics.hpp"

#include <algorithm>
#include <optional>

#include "gap/identify/body/mechanics_entry.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Indices of the effects in these limbs whose numbers motion decides.
std::vector<std::size_t> freeIn(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                const std::vector<std::size_t>& limbs) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].is_in_controller) continue;  // a motion that is not quite right must not move what loads show directly
    if (isInOneOf(robot, found[i].placed, limbs)) free.push_back(i);
  }
  return free;
}

/// Start in another local minimum: the first number of one effect scaled, if that alone lowers the cost. The cost of
/// plays and delays has a local minimum for each reading that shifts to another row.
std::optional<std::vector<PlacedMechanics>> outOfValley(const ClampedRobot& robot, const MechanicsFit& fit,
                                                        const std::vector<std::size_t>& free,
                                                        const std::vector<std::size_t>& limbs) {
  std::optional<std::vector<PlacedMechanics>> best;
  double least = costOf(robot, limbs, with(robot, fit.effects));
  for (const std::size_t i : free) {
    const MechanicalEffect::Number& number = fit.effects[i].effect->numbers.front();
    for (const double strength : thresholds::kMechanicsStrengths) {
      std::vector<PlacedMechanics> other = fit.effects;
      double& value = other[i].values.front();
      value = std::clamp(number.neutral + strength * (value - number.neutral), number.low, number.high);
      const double cost = costOf(robot, limbs, with(robot, other));
      if (cost < least) least = cost, best = std::move(other);
    }
  }
  return best;
}

MechanicsFit fitFrom(const ClampedRobot& robot, std::vector<PlacedMechanics> start,
                     const std::vector<std::size_t>& free) {
  return fitMechanics(robot, std::move(start), free, false, thresholds::kMechanicsIterations);
}

MechanicsFit fitThroughValleys(const ClampedRobot& robot, std::vector<PlacedMechanics> effects,
                               const std::vector<std::size_t>& free) {
  MechanicsFit fit = fitFrom(robot, std::move(effects), free);
  std::vector<PlacedMechanics> moved;
  for (const std::size_t i : free) moved.push_back(fit.effects[i]);
  const std::vector<std::size_t> limbs = limbsOf(robot, moved);
  for (int valley = 0; valley < thresholds::kMechanicsValleys; ++valley) {
    std::optional<std::vector<PlacedMechanics>> start = outOfValley(robot, fit, free, limbs);
    if (!start) break;
    MechanicsFit other = fitFrom(robot, std::move(*start), free);
    if (!(other.cost < fit.cost)) break;  // the priors count as well
    fit = std::move(other);
  }
  return fit;
}

void setFitted(std::vector<FoundMechanics>& found, const MechanicsFit& fit, const std::vector<std::size_t>& free) {
  for (const std::size_t i : free) found[i].placed = fit.effects[i], found[i].sigmas = fit.sigmas[i];
}

/// The other effects, refitted, if this one is superfluous. Not so if no other effect in its limbs is free.
std::optional<std::vector<FoundMechanics>> without(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                                   std::size_t one) {
  std::vector<FoundMechanics> others = found;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(one));
  const PlacedMechanics& placed = found[one].placed;
  const std::vector<std::size_t> free = freeIn(robot, others, limbsOf(robot, {placed}));
  if (free.empty()) return {};
  const MechanicsFit fit = fitFrom(robot, effectsOf(others), free);
  std::vector<PlacedMechanics> moved{placed};
  for (const std::size_t i : free) moved.push_back(fit.effects[i]);
  const std::vector<std::size_t> limbs = limbsOf(robot, moved);
  const double lost =
      costOf(robot, limbs, with(robot, fit.effects)) - costOf(robot, limbs, with(robot, effectsOf(found)));
  if (lost >= priceOf(robot, placed, freeNumbers(*placed.effect))) return {};
  setFitted(others, fit, free);
  return others;
}

}  // namespace

void refitMechanics(ClampedRobot& robot, std::vector<FoundMechanics>& found) {
  const std::vector<std::size_t> touched = limbsOf(robot, {found.back().placed});
  const std::vector<std::size_t> free = freeIn(robot, found, touched);
  robot.renew(touched, with(robot, effectsOf(found)));
  setFitted(found, fitThroughValleys(robot, effectsOf(found), free), free);
}

std::vector<std::size_t> dropSuperfluous(ClampedRobot& robot, std::vector<FoundMechanics>& found) {
  std::vector<PlacedMechanics> dropped;
  for (std::size_t i = 0; i < found.size();) {
    std::optional<std::vector<FoundMechanics>> others = without(robot, found, i);
    if (!others) {
      ++i;
      continue;
    }
    const FoundMechanics gone = std::move(found[i]);
    found = std::move(*others);
    const std::vector<std::size_t> limbs = limbsOf(robot, {gone.placed});
    for (FoundMechanics& other : found) {
      if (!isInOneOf(robot, other.placed, limbs)) continue;
      other.excess_before = std::max(other.excess_before, gone.excess_before);  // it now has to explain this alone
      std::erase_if(other.rivals, [&](const PlacedMechanics& rival) { return rival.sameName(gone.placed); });
    }
    robot.renew(limbs, with(robot, effectsOf(found)));
    dropped.push_back(gone.placed);
    i = 0;
  }
  return limbsOf(robot, dropped);
}

}  // namespace darwinop::gap
