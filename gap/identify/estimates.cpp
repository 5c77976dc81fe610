// Numbers of an effect with their intervals.
#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/identify/assessment.hpp"
#include "gap/identify/jackknife.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Residuals over independent ones, where the errors of a wrong model are correlated.
double correlatedSamples(const Evidence& evidence) {
  double residuals = 0, independent = 0;
  for (std::size_t i = 0; i < evidence.logs.size(); ++i) {
    const Trajectory& log = evidence.given->logs[evidence.logs[i]];
    const double period_s = log.duration_s() / static_cast<double>(log.rows() - 1);
    const auto size = static_cast<double>(evidence.noise[i].size());
    residuals += size;
    independent += size / std::max(1.0, thresholds::kCorrelatedSamples * thresholds::kCorrelatedPeriod / period_s);
  }
  return residuals / independent;
}

}  // namespace

std::vector<Estimate> estimatesOf(const FittedModel& fitted, const twin::EffectInfo& effect, double excess) {
  // The residual of a wrong model is not white: neighbouring samples are correlated, and all of a log to some extent.
  // A model by the numbers of a manual is always a little wrong.
  const bool is_wrong =
      excess > thresholds::kRightCostRatio || fitted.evidence->discrepancy.any() || isRoughlyKnown(fitted.study->data);
  const double wider =
      excess > thresholds::kRightCostRatio ? std::sqrt(correlatedSamples(*fitted.evidence) * excess) : 1;
  const std::optional<Eigen::VectorXd> by_logs = is_wrong ? halfWidthsByLogs(fitted) : std::nullopt;
  std::vector<Estimate> estimates;
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const EffectParameter* const own = unknowns[i].parameterOf(effect);
    if (own == nullptr) continue;
    const twin::Parameter& parameter = own->row();
    const auto at = static_cast<Eigen::Index>(i);
    if (!std::isfinite(fitted.fit.covariance(at, at))) {
      estimates.push_back(
          {unknowns[i].name, std::string{parameter.unit}, parameter.neutral, unknowns[i].low, unknowns[i].high, false});
      continue;
    }
    const double x = fitted.fit.x[at], value = unknowns[i].fromSearch(x);
    const double sharpest = thresholds::kFinestInterval * (unknowns[i].logarithmic ? 1 : std::abs(value));
    const double local = wider * std::sqrt(fitted.fit.covariance(at, at));
    double half = std::max(sharpest, thresholds::kInterval90 * local);
    if (by_logs) half = std::fmax(half, (*by_logs)[at]);
    if (parameter.role == twin::ParameterRole::kGoalDelay) {
      // A goal acts from the first firmware period after it arrives; its instant within the period before is unknown.
      const double early = fitted.problem.hypothesis().servo.firmware_period_s / 2;
      const double later = std::max(early, unknowns[i].fromSearch(x + half) - value);
      estimates.push_back({unknowns[i].name, "s", value - early, std::max(0.0, value - early - later),
                           std::min(unknowns[i].high, value - early + later)});
      continue;
    }
    estimates.push_back({unknowns[i].name, std::string{parameter.unit}, value,
                         std::max(unknowns[i].low, unknowns[i].fromSearch(x - half)),
                         std::min(unknowns[i].high, unknowns[i].fromSearch(x + half))});
  }
  return estimates;
}

}  // namespace darwinop::gap
