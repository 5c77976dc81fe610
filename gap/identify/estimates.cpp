// Numbers of an effect with their intervals.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "gap/identify/assessment.hpp"
#include "gap/identify/cross_validation.hpp"
#include "gap/identify/few_logs.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Variance of the unknowns by the jackknife over logs: how far each log by itself, with its repeats, pulls them, to
/// first order. The error of a wrong model is the same all over a log, so samples of one log are one piece of evidence.
Eigen::MatrixXd jackknifeCovariance(const FittedModel& fitted) {
  const Eigen::Index count = fitted.fit.x.size();
  const Evidence& evidence = *fitted.evidence;
  const std::vector<std::vector<std::size_t>> groups = independentLogs(evidence);
  const auto logs = static_cast<double>(groups.size());
  std::vector<Eigen::Index> begin{0};  // of each log's residuals
  for (const LogNoise& noise : evidence.noise) begin.push_back(begin.back() + noise.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  for (const std::vector<std::size_t>& group : groups) {
    Eigen::MatrixXd others = fitted.fit.information;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
    for (const std::size_t i : group) {
      const Eigen::Index size = evidence.noise[i].size();
      const Eigen::VectorXd residuals = fitted.fit.residuals.segment(begin[i], size);
      const Eigen::MatrixXd jacobian = fitted.fit.jacobian.middleRows(begin[i], size);
      const Eigen::VectorXd weights = residuals.unaryExpr(
          [](double r) { return 1 / std::sqrt(1 + r * r / (thresholds::kRobustSigmas * thresholds::kRobustSigmas)); });
      const Eigen::MatrixXd weighted = jacobian.transpose() * weights.asDiagonal();
      others -= weighted * jacobian;
      gradient += weighted * residuals;
    }
    const Eigen::VectorXd pull = others.ldlt().solve(gradient);
    covariance += pull * pull.transpose() * ((logs - 1) / logs);
  }
  return covariance;
}

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
  const bool is_wrong = excess > thresholds::kRightCostRatio || fitted.evidence->discrepancy.any();
  const double wider =
      excess > thresholds::kRightCostRatio ? std::sqrt(correlatedSamples(*fitted.evidence) * excess) : 1;
  const auto logs = std::ssize(independentLogs(*fitted.evidence));
  const bool by_logs =
      is_wrong && logs >= CrossValidation::kFewestLogs && fitted.fit.jacobian.cols() == fitted.fit.x.size();
  const Eigen::MatrixXd over_logs = by_logs ? jackknifeCovariance(fitted) : Eigen::MatrixXd{};
  std::vector<Estimate> estimates;
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || parameter->info != &effect) continue;
    const auto at = static_cast<Eigen::Index>(i);
    if (!std::isfinite(fitted.fit.covariance(at, at))) {
      estimates.push_back({unknowns[i].name, std::string{effect.parameters[parameter->index].unit},
                           effect.parameters[parameter->index].neutral, unknowns[i].low, unknowns[i].high, false});
      continue;
    }
    const double x = fitted.fit.x[at], value = unknowns[i].fromSearch(x);
    const double sharpest = thresholds::kFinestInterval * (unknowns[i].logarithmic ? 1 : std::abs(value));
    const double local = wider * std::sqrt(fitted.fit.covariance(at, at));
    double half = std::max(sharpest, thresholds::kInterval90 * local);
    if (by_logs) half = std::fmax(half, interval90(static_cast<int>(logs)) * std::sqrt(over_logs(at, at)));
    if (effect.parameters[parameter->index].role == twin::ParameterRole::kGoalDelay) {
      // A goal acts from the first firmware period after it arrives; its instant within the period before is unknown.
      const double early = fitted.problem.hypothesis().servo.firmware_period_s / 2;
      const double later = std::max(early, unknowns[i].fromSearch(x + half) - value);
      estimates.push_back({unknowns[i].name, "s", value - early, std::max(0.0, value - early - later),
                           std::min(unknowns[i].high, value - early + later)});
      continue;
    }
    estimates.push_back({unknowns[i].name, std::string{effect.parameters[parameter->index].unit}, value,
                         std::max(unknowns[i].low, unknowns[i].fromSearch(x - half)),
                         std::min(unknowns[i].high, unknowns[i].fromSearch(x + half))});
  }
  return estimates;
}

}  // namespace darwinop::gap
