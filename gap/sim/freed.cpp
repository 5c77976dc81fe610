#include "gap/sim/freed.hpp"

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

bool means(const twin::EffectInfo& effect, std::string_view number) {
  return std::ranges::find(kSameAs, std::pair{effect.id, number}) != kSameAs.end();
}

bool freesAPrior(const Case& given, const twin::EffectInfo& effect) {
  return std::ranges::any_of(given.priors, [&](const Prior& prior) { return means(effect, prior.number); });
}

double sigmasOfFreed(const Case& given, const Hypothesis& hypothesis, const twin::EffectInfo& effect) {
  const Hypothesis baseline = baselineOf(given);
  const twin::EffectSetting* const before = baseline.find(effect.id);
  const twin::EffectSetting* const after = hypothesis.find(effect.id);
  const auto moved = [&](double change, std::string_view number) {
    const auto prior = std::ranges::find(given.priors, number, &Prior::number);
    return prior != given.priors.end() && prior->relative_sigma > 0 ? std::abs(change) / prior->relative_sigma
                                                                    : kInfinity;
  };
  const double value = after->values[0];
  if (effect.id == "coulomb" || effect.id == "viscous") {
    const std::string number = std::string{effect.id} + "." + std::string{effect.parameters[0].key};
    return before == nullptr ? kInfinity : moved(value / before->values[0] - 1, number);
  }
  if (effect.id == "kt_error") return moved(value, "kt");
  if (effect.id == "resistance_error") return moved(value, "resistance");
  if (effect.id == "inertia") return moved(value / baseline.servo.armature_kgm2, "armature");
  if (effect.id == "com_mass")
    return std::max(moved(value, "payload"), moved(after->values[1] / baseline.pendulum.length_m, "length"));
  return kInfinity;
}

}  // namespace darwinop::gap
