#include "gap/identify/assessment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/identify/jackknife.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

double sigmasOff(const FittedModel& fitted, std::size_t i) {
  const Unknown& unknown = fitted.problem.unknowns()[i];
  if (!std::isfinite(unknown.sigma)) return 0;
  return (unknown.fromSearch(fitted.fit.x[static_cast<Eigen::Index>(i)]) - unknown.expected) / unknown.sigma;
}

}  // namespace

double misfitOf(const FittedModel& fitted, const Bootstrap& bootstrap) {
  return (fitted.fit.cost - fitted.fit.prior - bootstrap.cost_mean) / bootstrap.cost_sigma;
}

double largestPriorSigma(const FittedModel& fitted) {
  double most = 0;
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i)
    most = std::max(most, std::abs(sigmasOff(fitted, i)));
  return most;
}

double leastGain(const Study& study, const Hypothesis& model, const twin::EffectInfo& effect, double threshold) {
  const bool conflict = aliasesAPrior(study.data, effect) &&
                        priorSigmasMoved(study.data, study.baseline, model, effect) > thresholds::kPriorTensionSigmas;
  return conflict ? thresholds::kPriorReleaseGain : threshold;
}

// Noise alone would make of a slightly wrong model, as one by the numbers of a manual always is, a conflict in whatever
// number the logs determine least.
std::vector<PriorConflict> priorConflictsOf(const FittedModel& fitted) {
  std::vector<PriorConflict> conflicts;
  const std::optional<Eigen::VectorXd> by_logs =
      isRoughlyKnown(fitted.study->data) ? halfWidthsByLogs(fitted) : std::nullopt;
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i) {
    const Unknown& unknown = fitted.problem.unknowns()[i];
    const double sigmas = sigmasOff(fitted, i);
    if (std::abs(sigmas) <= thresholds::kPriorConflictSigmas) continue;
    const auto at = static_cast<Eigen::Index>(i);
    const double x = fitted.fit.x[at];
    if (by_logs && std::abs(x - unknown.toSearch(unknown.expected)) < (*by_logs)[at]) continue;
    conflicts.push_back({unknown.name, sigmas, unknown.fromSearch(x) / unknown.expected});
  }
  return conflicts;
}

Hypothesis withoutUndetermined(const FittedModel& fitted) {
  Hypothesis found = fitted.hypothesis();
  for (std::size_t i = 0; i < fitted.problem.unknowns().size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&fitted.problem.unknowns()[i].what);
    const auto at = static_cast<Eigen::Index>(i);
    if (parameter == nullptr || std::isfinite(fitted.fit.covariance(at, at))) continue;
    Hypothesis neutral = found;
    neutral.with(*parameter->info).values[parameter->index] = parameter->row().neutral;
    const Problem as_found{*fitted.evidence, found, {}}, as_neutral{*fitted.evidence, neutral, {}};
    if (as_neutral.cost({}) < as_found.cost({}) + 1) found = std::move(neutral);
  }
  return found;
}

bool isAtItsBound(const FittedModel& fitted, const twin::EffectInfo& effect) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const EffectParameter* const parameter = unknowns[i].parameterOf(effect);
    if (parameter == nullptr || std::isfinite(unknowns[i].sigma)) continue;
    const double low = unknowns[i].toSearch(unknowns[i].low), high = unknowns[i].toSearch(unknowns[i].high);
    const double neutral = unknowns[i].toSearch(parameter->row().neutral);
    const double x = fitted.fit.x[static_cast<Eigen::Index>(i)], near = thresholds::kBoundMargin * (high - low);
    if ((x < low + near && neutral > low + near) || (x > high - near && neutral < high - near)) return true;
  }
  return false;
}

bool isNegligible(const FittedModel& fitted, const twin::EffectInfo& effect) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const EffectParameter* const own = unknowns[i].parameterOf(effect);
    if (own == nullptr || own->row().secondary) continue;
    const double value = unknowns[i].fromSearch(fitted.fit.x[static_cast<Eigen::Index>(i)]);
    const double range = own->row().high - own->row().low;
    if (std::abs(value - own->row().neutral) > thresholds::kNegligibleShare * range) return false;
  }
  return !unknownsOf(effect).empty();
}

double floorOf(const FittedModel& fitted) {
  return floorOf(*fitted.evidence);
}

double floorOf(const Evidence& evidence) {
  RmsSum sum;
  for (const LogNoise& noise : evidence.noise) sum.add(noise.positionFloor());
  return sum.rms();
}

Verdict verdictOf(const Identification& found) {
  const bool is_noise = found.misfit < thresholds::kMisfitSigmas;
  if (found.effects.empty()) {
    if (is_noise) return found.prior_conflicts.empty() ? Verdict::kNone : Verdict::kCannotTell;
    return found.gap_after_rad < thresholds::kLeastGapFloors * found.floor_rad ? Verdict::kCannotTell
                                                                               : Verdict::kUnknown;
  }
  const bool most_removed = found.gap_after_rad < thresholds::kRemainingFloors * found.floor_rad &&
                            found.gap_after_rad < (1 - thresholds::kExplainedGapShare) * found.gap_before_rad;
  return is_noise || most_removed ? namedOrAmbiguous(found) : Verdict::kUnknown;
}

// If much of the error remains, the effects found may stand for something else.
Verdict verdictOfRough(const Identification& found, double mean_before_rad, double mean_after_rad) {
  const bool mostly = mean_after_rad < thresholds::kHopelessGapShare * mean_before_rad;
  return mostly && !found.effects.empty() ? namedOrAmbiguous(found) : Verdict::kUnknown;
}

Verdict namedOrAmbiguous(const Identification& found) {
  return std::ranges::any_of(found.rivals, &Rival::isClose) ? Verdict::kAmbiguous : Verdict::kNamed;
}

}  // namespace darwinop::gap
