// Effects of joints and links that recordings with a clamped trunk show: those of the servo's catalogue, in one joint,
// a pair or all, and masses of links.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

/// Ends the key of an addition in an answer: `friction_added`. `friction` is the total.
inline constexpr std::string_view kAddedEnding = "_added";

struct MechanicalEffect {
  struct Number {
    std::string_view key, unit;
    double low, high, neutral, typical;
    double prior_sigma = 0;     // about neutral; 0: flat in the range
    bool is_secondary = false;  // at its typical value until the effect is accepted
    bool is_logarithmic = false;
    bool is_addition = false;  // to the joint's own number in the model
  };
  std::string_view id;
  bool is_of_link = false;  // in one link; others also in a pair or in all joints
  std::vector<Number> numbers;
  /// With these values in this joint, or in the link that it moves.
  std::function<void(BodyHypothesis&, Joint, const std::vector<double>& values)> apply;
  /// Values of the hypothesis itself; of an addition: 0.
  std::function<std::vector<double>(const BodyHypothesis&, Joint)> values_in;
};

/// Of an effect whose first number is an addition: what the robot has at this joint.
double ownNumber(const BodyHypothesis& robot, const MechanicalEffect& effect, Joint joint);

/// In the order of the catalogue, then links. To add one: a row in mechanical_effect.cpp.
const std::vector<MechanicalEffect>& mechanicalEffects();

/// Numbers of a first search: refinements are free only where a prior holds them.
std::size_t freeNumbers(const MechanicalEffect& effect);

/// Values from which a search starts: the other numbers at their typical values.
std::vector<std::vector<double>> startsOf(const MechanicalEffect& effect, const std::vector<double>& now);

/// The other joint of a pair, of the right one; nothing for neck and head.
std::optional<Joint> leftOf(Joint joint);

/// An effect at its places, with its values.
struct PlacedMechanics {
  const MechanicalEffect* effect = nullptr;
  std::vector<Joint> joints;
  std::vector<double> values;

  void applyTo(BodyHypothesis& robot) const {
    for (const Joint joint : joints) effect->apply(robot, joint, values);
  }
  [[nodiscard]] bool sameName(const PlacedMechanics& other) const {
    return effect->id == other.effect->id && joints == other.joints;
  }
};

/// Mass and centre of mass of one link.
inline bool sameLink(const PlacedMechanics& a, const PlacedMechanics& b) {
  return a.effect->is_of_link && b.effect->is_of_link && a.joints == b.joints && a.effect != b.effect;
}

}  // namespace darwinop::gap
