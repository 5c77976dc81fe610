#include "gap/localize/command_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gap/fit/problem.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using EffectList = std::vector<const twin::EffectInfo*>;

/// Effects of the command are visible only while the goal moves; those of the controller, a scaled goal among them, at
/// rest as well.
EffectList visibleIn(twin::LoopPart part) {
  EffectList effects;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    if (effect->part == part && effect->visibility == twin::Visibility::kAtHost) effects.push_back(effect);
  return effects;
}

/// Values to try for one parameter, from hardly visible to plain.
std::vector<double> valuesToTry(const twin::Parameter& parameter) {
  std::vector<double> values;
  constexpr std::array kShares{0.02, 0.05, 0.1, 0.25, 0.5, 0.8};  // of the way from neutral to an end
  if (parameter.logarithmic && parameter.neutral > parameter.low && parameter.neutral < parameter.high) {
    for (const double share : kShares)
      for (const double end : {std::max(parameter.low, parameter.neutral / 300), parameter.high})
        values.push_back(parameter.neutral * std::pow(end / parameter.neutral, share));
    return values;
  }
  if (parameter.logarithmic) {
    const double low = std::max(parameter.low, parameter.high / 300);
    for (double share = 0; share <= 1.001; share += 1.0 / 9)
      values.push_back(low * std::pow(parameter.high / low, share));
    return values;
  }
  for (const double share : kShares)
    for (const double end : {parameter.low, parameter.high})
      if (end != parameter.neutral) values.push_back(parameter.neutral + share * (end - parameter.neutral));
  return values;
}

struct Try {
  const twin::EffectInfo* effect;
  std::size_t parameter;
  double value;
};

Hypothesis withTry(const Case& given, const Hypothesis& hypothesis, const Try& one) {
  Hypothesis changed = hypothesis;
  twin::EffectSetting& setting = changed.with(*one.effect);
  setting.values[one.parameter] = one.value;
  if (one.effect->laws == twin::Laws::kReplacesSpeedP && given.datasheet) {  // the law's numbers are the data sheet's
    const twin::ServoParameters& sheet = given.datasheet->servo;
    changed.servo.kt_nm_a = sheet.kt_nm_a;
    changed.servo.resistance_ohm = sheet.resistance_ohm;
    changed.servo.back_emf_vs_rad = sheet.back_emf_vs_rad;
    changed.servo.duty_per_kp_per_rad = sheet.duty_per_kp_per_rad;
    changed.servo.duty_max = sheet.duty_max;
    changed.servo.supply_v = sheet.supply_v;
  }
  return changed;
}

std::vector<Try> triesOf(const EffectList& effects, const Hypothesis& hypothesis) {
  std::vector<Try> tries;
  for (const twin::EffectInfo* const effect : effects) {
    if (hypothesis.find(effect->id) != nullptr) continue;
    if (effect->laws == twin::Laws::kReplacesSpeedP) {
      if (hypothesis.servo.law == twin::Law::kSpeedP) tries.push_back({effect, 0, 1});
      continue;
    }
    for (std::size_t i = 0; i < effect->parameters.size(); ++i)
      if (!effect->parameters[i].secondary)
        for (const double value : valuesToTry(effect->parameters[i])) tries.push_back({effect, i, value});
  }
  return tries;
}

/// Remaining cost, and its hypothesis.
struct Least {
  double cost;
  Hypothesis hypothesis;
};

/// The best of the tries on top of a hypothesis, and of its neighbourhood.
Least leastOf(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
              const BlockTest& judged, const Least& from, std::vector<Try> tries) {
  Least least = from;
  Try best{nullptr, 0, 0};
  const auto run = [&] {
    std::vector<double> costs(tries.size(), from.cost);
    forEach(tries.size(), [&](std::size_t i) {
      try {
        costs[i] = blockCostUnder(cut, given, logs, judged, withTry(given, from.hypothesis, tries[i]));
      } catch (const std::runtime_error&) {  // an impossible hypothesis explains nothing
      }
    });
    for (std::size_t i = 0; i < tries.size(); ++i)
      if (costs[i] < least.cost) {
        best = tries[i];
        least = {costs[i], withTry(given, from.hypothesis, best)};
      }
  };
  run();
  // Between the values tried, the best one's neighbourhood.
  for (const double step : {0.3, 0.1, 0.03, 0.01, 0.003}) {
    if (best.effect == nullptr) break;
    const twin::Parameter& parameter = best.effect->parameters[best.parameter];
    tries.clear();
    for (const double side : {-2.0, -1.0, 1.0, 2.0}) {
      const double value = parameter.logarithmic
                               ? best.value * std::exp(side * step)
                               : parameter.neutral + (best.value - parameter.neutral) * (1 + side * step);
      tries.push_back({best.effect, best.parameter, std::clamp(value, parameter.low, parameter.high)});
    }
    run();
  }
  return least;
}

Explained explain(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                  const BlockTest& judged, const Hypothesis& hypothesis, const EffectList& effects) {
  const double before = blockCostUnder(cut, given, logs, judged, hypothesis);
  const double beyond_noise = before - judged.expected_cost;
  if (!(beyond_noise > 0)) return {0, hypothesis};  // nothing to explain
  Least least{before, hypothesis};
  double share = 0;
  for (int changes = 0; changes < 2 && share < thresholds::kSplitExplainsAll; ++changes) {
    least = leastOf(cut, given, logs, judged, least, triesOf(effects, least.hypothesis));
    share = std::min(1.0, (before - least.cost) / beyond_noise);
  }
  return {share, least.hypothesis};
}

/// Cost beyond noise of a sample whose goal has stood for a while, as a share of that of any sample: sweeps hardly
/// rest.
double shareAtRest(const Case& given, const std::vector<std::size_t>& logs, const BlockTest& judged) {
  double rest = 0, all = 0, resting_samples = 0, samples_in_all = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const Trajectory& log = given.logs[logs[i]];
    const BlockResiduals& samples = judged.samples[i];
    for (Eigen::Index k = 0; k < samples.z.size(); ++k) {
      if (std::isnan(samples.residual[k])) continue;
      const std::size_t row = samples.row[static_cast<std::size_t>(k)];
      std::size_t since = row;
      while (since > 0 && log.goal_rad[since - 1] == log.goal_rad[row] && log.torque_on[since - 1] != 0) --since;
      const double excess = costOf(samples.z[k]) - 1;
      all += excess, ++samples_in_all;
      if (log.time_s[row] - log.time_s[since] > thresholds::kGoalAtRest) rest += excess, ++resting_samples;
    }
  }
  return all > 0 && rest > 0 ? (rest / resting_samples) / (all / samples_in_all) : 0;
}

}  // namespace

bool CommandSplit::isCommand() const {
  if (std::max(by_command.share, by_controller.share) < thresholds::kSplitExplains)
    return at_rest < thresholds::kSplitRestIsNone;
  return by_command.share > by_controller.share;
}

CommandSplit splitCommand(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                          const BlockTest& judged, const Hypothesis& hypothesis) {
  return {.by_command = explain(cut, given, logs, judged, hypothesis, visibleIn(twin::LoopPart::kCommand)),
          .by_controller = explain(cut, given, logs, judged, hypothesis, visibleIn(twin::LoopPart::kController)),
          .at_rest = shareAtRest(given, logs, judged)};
}

Explained explainByDelay(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                         const BlockTest& judged, const Hypothesis& hypothesis) {
  const twin::EffectInfo* const delay = twin::effectWith(twin::ParameterRole::kGoalDelay);
  return explain(cut, given, logs, judged, hypothesis, delay == nullptr ? EffectList{} : EffectList{delay});
}

}  // namespace darwinop::gap
