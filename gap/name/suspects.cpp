#include "gap/name/suspects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "gap/sim/freed.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

// Only the firmware's own clock and encoder know of these; a host at 16 ms sees their noise.
constexpr auto kUnseen = std::to_array<std::string_view>({"lost_packets", "encoder_quantisation"});
// What a motor that takes any speed at once does not have.
constexpr auto kNeedVoltage =
    std::to_array<std::string_view>({"supply_sag", "kt_error", "resistance_error", "integral", "derivative"});

template <class List>
bool contains(const List& list, std::string_view id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

constexpr double kRoughly = 0.1;  // of a number: no worse, and a measurement stands behind it

}  // namespace

std::vector<const twin::EffectInfo*> suspectsOf(const Case& given) {
  const bool voltage = given.model.servo.law == twin::Law::kVoltageP;
  std::vector<const twin::EffectInfo*> suspects;
  for (const twin::EffectInfo* const effect : twin::catalogue()) {
    if (contains(kUnseen, effect->id)) continue;
    if (voltage ? effect->id == "p_on_torque" : contains(kNeedVoltage, effect->id)) continue;
    if (effect->id == "p_on_torque" && !given.datasheet) continue;
    suspects.push_back(effect);
  }
  return suspects;
}

bool has(const Effects& effects, const twin::EffectInfo& effect) {
  return std::any_of(effects.begin(), effects.end(), [&](const Chosen& chosen) { return chosen.info == &effect; });
}

Effects without(Effects effects, std::size_t i) {
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(i));
  return effects;
}

bool isRoughlyKnown(const Case& given) {
  return std::ranges::any_of(given.priors, [](const Prior& prior) {
    return (prior.number == "kt" || prior.number == "resistance") && prior.relative_sigma >= kRoughly;
  });
}

Problem problemWith(const Evidence& evidence, const Effects& effects, Numbers numbers) {
  Hypothesis hypothesis = baselineOf(*evidence.given);
  std::vector<Unknown> own;
  for (const Chosen& effect : effects) {
    twin::EffectSetting& setting = hypothesis.with(*effect.info);
    if (effect.info->id == "p_on_torque") valueOf(setting, "on") = 1;
    for (Unknown& unknown : unknownsOf(*effect.info, effect.refined)) own.push_back(std::move(unknown));
  }
  std::vector<Unknown> all;
  all = nuisancesOf(*evidence.given, hypothesis);
  // What a data sheet says of another law's motor is no number of the baseline, and never exact.
  const bool other_motor = hypothesis.servo.law != twin::Law::kVoltageP && hypothesis.find("p_on_torque") != nullptr;
  if (numbers == Numbers::kHeld)
    std::erase_if(all,
                  [&](const Unknown& one) { return !other_motor || (one.name != "kt" && one.name != "resistance"); });
  std::erase_if(all, [&](const Unknown& nuisance) {  // an effect says the same
    const bool of_an_effect = nuisance.name.find('.') != std::string::npos;
    return of_an_effect &&
           std::ranges::any_of(effects, [&](const Chosen& chosen) { return means(*chosen.info, nuisance.name); });
  });
  all.insert(all.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  return {evidence, std::move(hypothesis), std::move(all)};
}

Eigen::VectorXd startFrom(const Problem& problem, const Problem& known, const Eigen::VectorXd& x) {
  Eigen::VectorXd start = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i)
    for (std::size_t j = 0; j < known.unknowns().size(); ++j)
      if (problem.unknowns()[i].name == known.unknowns()[j].name) {
        const double value = known.unknowns()[j].fromSearch(x[static_cast<Eigen::Index>(j)]);
        start[static_cast<Eigen::Index>(i)] = problem.unknowns()[i].toSearch(value);
      }
  return start;
}

Eigen::VectorXd startAfresh(const Problem& problem, const Problem& known, const Eigen::VectorXd& x) {
  Eigen::VectorXd start = startFrom(problem, known, x);
  const Eigen::VectorXd expected = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (std::isfinite(problem.unknowns()[i].sigma)) start[at] = expected[at];
  }
  return start;
}

}  // namespace darwinop::gap
