#include "gap/identify/jackknife.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "gap/identify/cross_validation.hpp"
#include "gap/identify/few_logs.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Variance of the unknowns by the jackknife over logs: how far each log by itself, with its repeats, pulls them, to
/// first order. The error of a wrong model is the same all over a log, so samples of one log are one piece of evidence.
Eigen::VectorXd jackknifeVariance(const FittedModel& fitted, const std::vector<std::vector<std::size_t>>& groups) {
  const Eigen::Index count = fitted.fit.x.size();
  const Evidence& evidence = *fitted.evidence;
  const auto logs = static_cast<double>(groups.size());
  const std::vector<Eigen::Index> first_row = evidence.firstRows();
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count);
  for (const std::vector<std::size_t>& group : groups) {
    Eigen::MatrixXd others = fitted.fit.information;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
    for (const std::size_t i : group) {
      const Eigen::Index size = evidence.noise[i].size();
      const Eigen::VectorXd residuals = fitted.fit.residuals.segment(first_row[i], size);
      const Eigen::MatrixXd jacobian = fitted.fit.jacobian.middleRows(first_row[i], size);
      const Eigen::VectorXd weights = residuals.unaryExpr(
          [](double r) { return 1 / std::sqrt(1 + r * r / (thresholds::kRobustSigmas * thresholds::kRobustSigmas)); });
      const Eigen::MatrixXd weighted = jacobian.transpose() * weights.asDiagonal();
      others -= weighted * jacobian;
      gradient += weighted * residuals;
    }
    const Eigen::VectorXd pull = others.ldlt().solve(gradient);
    variance += pull.cwiseAbs2() * ((logs - 1) / logs);
  }
  return variance;
}

}  // namespace

std::optional<Eigen::VectorXd> halfWidthsByLogs(const FittedModel& fitted) {
  const std::vector<std::vector<std::size_t>> groups = independentLogs(*fitted.evidence);
  const auto logs = static_cast<int>(groups.size());
  if (logs < CrossValidation::kFewestLogs || fitted.fit.jacobian.cols() != fitted.fit.x.size()) return std::nullopt;
  return interval90(logs) * jackknifeVariance(fitted, groups).cwiseSqrt();
}

}  // namespace darwinop::gap
