#include "gap/identify/jackknife.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <vector>

#include "gap/identify/cross_validation.hpp"
#include "gap/identify/few_logs.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// How far each log by itself, with its repeats, pulls the unknowns, to first order: a column each. Infinite where no
/// other log shows an unknown.
Eigen::MatrixXd pullsOf(const FittedModel& fitted, const std::vector<std::vector<std::size_t>>& groups) {
  const Evidence& evidence = *fitted.evidence;
  const Eigen::MatrixXd& information = fitted.fit.information;
  const std::vector<Eigen::Index> first_row = evidence.firstRows();
  Eigen::MatrixXd pulls(fitted.fit.x.size(), static_cast<Eigen::Index>(groups.size()));
  for (std::size_t group = 0; group < groups.size(); ++group) {
    Eigen::MatrixXd others = information;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fitted.fit.x.size());
    for (const std::size_t i : groups[group]) {
      const Eigen::Index size = evidence.noise[i].size();
      const Eigen::VectorXd residuals = fitted.fit.residuals.segment(first_row[i], size);
      const Eigen::MatrixXd jacobian = fitted.fit.jacobian.middleRows(first_row[i], size);
      const Eigen::VectorXd weights = residuals.unaryExpr(&weightOf);
      const Eigen::MatrixXd weighted = jacobian.transpose() * weights.asDiagonal();
      others -= weighted * jacobian;
      gradient += weighted * residuals;
    }
    auto pull = pulls.col(static_cast<Eigen::Index>(group));
    pull = others.ldlt().solve(gradient);
    for (Eigen::Index i = 0; i < pull.size(); ++i)
      if (others(i, i) <= thresholds::kUnobservableEigenvalue * information(i, i))
        pull[i] = std::numeric_limits<double>::infinity();
  }
  return pulls;
}

}  // namespace

// The jackknife over logs: the error of a wrong model is the same all over a log, so samples of one log are one piece
// of evidence. What pulls all logs alike is the prior.
std::optional<Eigen::VectorXd> halfWidthsByLogs(const FittedModel& fitted) {
  const std::vector<std::vector<std::size_t>> groups = independentLogs(*fitted.evidence);
  const auto logs = static_cast<int>(groups.size());
  if (logs < CrossValidation::kFewestLogs || fitted.fit.jacobian.size() == 0) return std::nullopt;
  const Eigen::MatrixXd pulls = pullsOf(fitted, groups);
  Eigen::VectorXd half_widths(pulls.rows());
  for (Eigen::Index i = 0; i < pulls.rows(); ++i)
    half_widths[i] = pulls.row(i).allFinite() ? interval90(logs) * std::sqrt((logs - 1.0) / logs) *
                                                    (pulls.row(i).array() - pulls.row(i).mean()).matrix().norm()
                                              : std::numeric_limits<double>::infinity();
  return half_widths;
}

bool mayBeNone(const FittedModel& fitted, const ChosenEffect& effect) {
  const std::optional<Eigen::VectorXd> half_widths = halfWidthsByLogs(fitted);
  if (!half_widths) return false;
  const Eigen::VectorXd off = (fitted.fit.x - takenOut(fitted, effect, fitted.fit.x)).cwiseAbs();
  return (off.array() <= half_widths->array()).all();
}

}  // namespace darwinop::gap
