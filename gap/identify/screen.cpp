#include "gap/identify/screen.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gap/fit/servo_range.hpp"
#include "gap/identify/ripple_starts.hpp"
#include "gap/identify/start_grid.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Rows of the residuals, then one a prior.
Eigen::MatrixXd withPriors(const FittedModel& present) {
  const auto& unknowns = present.problem.unknowns();
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(present.fit.jacobian.rows() + count, count);
  all.topRows(present.fit.jacobian.rows()) = present.fit.jacobian;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    if (!std::isfinite(unknown.sigma)) continue;
    const double value = unknown.fromSearch(present.fit.x[i]);
    all(present.fit.jacobian.rows() + i, i) = (unknown.logarithmic ? value : 1) / unknown.sigma;
  }
  return all;
}

}  // namespace

Screen::Screen(const FittedModel& present, const std::vector<const twin::EffectInfo*>& effects)
    : present_{present}, jacobian_{withPriors(present)}, residuals_{present.fit.residuals} {
  if (jacobian_.cols() > 0) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr{jacobian_};
    absorbed_ = qr.householderQ() * Eigen::MatrixXd::Identity(jacobian_.rows(), qr.rank());
  } else {
    absorbed_.resize(residuals_.size(), 0);
  }

  for (const twin::EffectInfo* const effect : effects) {
    if (has(present.effects, *effect)) continue;
    if (isRipple(*effect)) {
      for (int count = 1; count <= thresholds::kMaxRipplesPerTurn; ++count)
        directions_.push_back(
            {{effect, {thresholds::kScreenRippleTorque, static_cast<double>(count), 0}, 0}, {}, true});
    } else {
      for (auto& values : gridOf(unknownsOf(*effect, present.study->baseline.servo)))
        directions_.push_back({{effect, std::move(values), 0}, {}, false});
      if (unknownsOf(*effect).empty()) continue;
    }
  }

  forEach(directions_.size(), [&](std::size_t i) {
    Direction& direction = directions_[i];
    Effects with = present.effects;
    with.push_back({direction.candidate.effect});
    const Problem problem = problemWith(*present.study, present.problem.evidence(), with, present.nuisance);
    Eigen::VectorXd x = startFrom(problem, present.problem, present.fit.x);
    const Eigen::Index rows = residuals_.size(), own = static_cast<Eigen::Index>(direction.candidate.values.size());
    for (Eigen::Index k = 0; k < own; ++k) {
      const Eigen::Index at = x.size() - own + k;
      const Unknown& unknown = problem.unknowns()[static_cast<std::size_t>(at)];
      x[at] = unknown.toSearch(direction.candidate.values[static_cast<std::size_t>(k)]);
    }
    direction.change = Eigen::MatrixXd::Zero(absorbed_.rows(), direction.either_way ? 2 : 1);
    Eigen::VectorXd there(rows);
    for (Eigen::Index column = 0; column < direction.change.cols(); ++column) {
      if (column == 1) x[x.size() - 1] = std::numbers::pi / 2;  // the other phase
      problem.residuals(x, there);
      direction.change.col(column).head(rows) = there - residuals_;
    }
    direction.change -= absorbed_ * (absorbed_.transpose() * direction.change);
  });
}

bool Screen::hasRipples() const {
  return std::ranges::any_of(directions_, [](const Direction& one) { return isRipple(*one.candidate.effect); });
}

Eigen::VectorXd Screen::withoutAbsorbed(Eigen::VectorXd extended) const {
  if (absorbed_.cols() > 0) extended -= absorbed_ * (absorbed_.transpose() * extended);
  return extended;
}

// The residuals are taken as linear in the share of the candidate's change, up to 1.3.
double Screen::predictedGain(const Direction& direction, const Eigen::VectorXd& residuals) const {
  const auto top = direction.change.topRows(residuals.size());
  if (direction.either_way) {
    const Eigen::Matrix2d gram = direction.change.transpose() * direction.change;
    const Eigen::Vector2d along = top.transpose() * residuals;
    if (!(gram.determinant() > 1e-9)) return 0;
    return along.dot(gram.ldlt().solve(along));
  }
  const double length = direction.change.squaredNorm();
  if (!(length > kLeastChange)) return 0;
  const double along = -top.col(0).dot(residuals), amount = std::clamp(along / length, 0.0, 1.3);
  return 2 * amount * along - amount * amount * length;
}

std::vector<Candidate> Screen::candidates() const {
  std::vector<Candidate> all;
  for (const Direction& direction : directions_) {
    Candidate candidate = direction.candidate;
    candidate.predicted_gain = predictedGain(direction, residuals_);
    if (direction.either_way && candidate.predicted_gain > 0) {  // amplitude and phase that fit
      const Eigen::Matrix2d gram = direction.change.transpose() * direction.change;
      const Eigen::Vector2d along = direction.change.topRows(residuals_.size()).transpose() * residuals_;
      const Eigen::Vector2d amount = -gram.ldlt().solve(along);
      candidate.values[0] = std::clamp(thresholds::kScreenRippleTorque * amount.norm(), 1e-4, 0.15);
      candidate.values[2] = std::atan2(amount[1], amount[0]);
    }
    all.push_back(std::move(candidate));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.predicted_gain > b.predicted_gain; });
  return all;
}

double Screen::greatestPredictedGain(const Eigen::VectorXd& residuals) const {
  double greatest = 0;
  for (const Direction& direction : directions_) greatest = std::max(greatest, predictedGain(direction, residuals));
  return greatest;
}

}  // namespace darwinop::gap
