#include "gap/identify/body/next_mechanics.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "gap/identify/body/log_agreement.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// The joint of the same kind on the other side.
std::optional<Joint> partnerOf(Joint joint) {
  if (const std::optional<Joint> left = leftOf(joint)) return left;
  const auto j = static_cast<std::size_t>(joint);
  if (joint >= Joint::kNeck) return std::nullopt;
  return static_cast<Joint>(j - 1);
}

/// The pair of an effect that was fitted to one joint, where the limb of the other joint is closed and yet shows it. A
/// limb that does not react says nothing about the pair: the one joint is the simpler name.
std::optional<PlacedMechanics> pairOf(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                      const PlacedMechanics& one, const std::vector<std::size_t>& open) {
  if (one.effect->is_of_link || one.joints.size() != 1) return {};
  const std::optional<Joint> partner = partnerOf(one.joints.front());
  if (!partner || isInOneOf(robot, {one.effect, {*partner}, one.values}, open)) return {};
  std::vector<PlacedMechanics> effects = effectsOf(found);
  const BodyHypothesis without = with(robot, effects);
  effects.push_back({one.effect, {*partner}, one.values});
  if (!supports(gainOf(robot, robot.limbOf(*partner), without, with(robot, effects)))) return {};
  PlacedMechanics pair = one;
  pair.joints.push_back(*partner);
  std::ranges::sort(pair.joints);
  return pair;
}

}  // namespace

std::vector<MechanicsEntry> nextMechanics(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                          const std::vector<std::size_t>& open, const std::vector<double>& excess,
                                          const std::vector<PlacedMechanics>& refused) {
  const std::vector<PlacedMechanics> now = effectsOf(found);
  std::vector<MechanicsEntry> common;
  if (open.size() >= thresholds::kLimbsOfAll) {
    common = fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAllJoints));
    const double sum = std::accumulate(excess.begin(), excess.end(), 0.0);
    const bool is_refused = std::ranges::any_of(common, [&](const MechanicsEntry& entry) {
      return std::ranges::any_of(refused, [&](const auto& one) { return one.sameName(entry.placed()); });
    });
    if (!common.empty() && !is_refused && common.front().gain > thresholds::kExplainedGapShare * sum) return common;
  }
  std::vector<MechanicsEntry> out = fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAny));
  std::vector<MechanicsEntry> pairs;
  for (const std::size_t i : bestOfLimbs(robot, out))
    if (const std::optional<PlacedMechanics> pair = pairOf(robot, found, out[i].placed(), open))
      pairs.push_back(fittedFrom(robot, found, *pair));
  for (auto* more : {&common, &pairs}) std::ranges::move(*more, std::back_inserter(out));
  std::ranges::stable_sort(out, std::greater{}, &MechanicsEntry::evidence);
  return out;
}

}  // namespace darwinop::gap
