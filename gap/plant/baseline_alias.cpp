#include "gap/plant/baseline_alias.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace darwinop::gap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr auto kSameAs = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"coulomb", "coulomb.friction"},
    {"viscous", "viscous.damping"},
    {"kt_error", "kt"},
    {"resistance_error", "resistance"},
    {"inertia", "armature"},
    {"com_mass", "payload"},
    {"com_mass", "length"},
    {"kp_scale", "duty_per_kp"},
});

}  // namespace

bool isAliasOf(const twin::EffectInfo& effect, std::string_view number) {
  return std::ranges::find(kSameAs, std::pair{effect.id, number}) != kSameAs.end();
}

bool aliasesAPrior(const Case& data, const twin::EffectInfo& effect) {
  return std::ranges::any_of(data.priors, [&](const Prior& prior) { return isAliasOf(effect, prior.number); });
}

double priorSigmasMoved(const Case& data, const Hypothesis& baseline, const Hypothesis& hypothesis,
                        const twin::EffectInfo& effect) {
  const twin::EffectSetting* const before = baseline.find(effect.id);
  const twin::EffectSetting* const after = hypothesis.find(effect.id);
  const auto moved = [&](double factor, std::string_view number) {
    const auto prior = std::ranges::find(data.priors, number, &Prior::number);
    if (factor == 1) return 0.0;
    return prior != data.priors.end() && prior->relative_sigma > 0 ? std::abs(factor - 1) / prior->relative_sigma
                                                                   : kInfinity;
  };
  const double value = after->values[0];
  const twin::ServoParameters &servo = hypothesis.servo, &was = baseline.servo;
  if (effect.id == "coulomb" || effect.id == "viscous") {
    const std::string number = std::string{effect.id} + "." + std::string{effect.parameters[0].key};
    return before == nullptr ? kInfinity : moved(value / before->values[0], number);
  }
  if (effect.id == "kp_scale") return moved(value * servo.duty_per_kp_per_rad / was.duty_per_kp_per_rad, "duty_per_kp");
  if (effect.id == "kt_error") return moved((1 + value) * servo.kt_nm_a / was.kt_nm_a, "kt");
  if (effect.id == "resistance_error")
    return moved((1 + value) * servo.resistance_ohm / was.resistance_ohm, "resistance");
  if (effect.id == "inertia") return moved((servo.armature_kgm2 + value) / was.armature_kgm2, "armature");
  if (effect.id != "com_mass") return kInfinity;
  const double length_m = hypothesis.pendulum.length_m + after->values[1];
  return std::max(moved((1 + value) * hypothesis.payload_scale, "payload"),
                  moved(length_m / baseline.pendulum.length_m, "length"));
}

}  // namespace darwinop::gap
