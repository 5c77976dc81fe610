#include "gap/name/screen.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gap/name/grid.hpp"
#include "gap/sim/parallel.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRipple = 0.004;  // small against what moves an arm

/// Rows of the residuals, then one a prior.
Eigen::MatrixXd withPriors(const Settled& present) {
  const auto& unknowns = present.problem.unknowns();
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(present.fit.slopes.rows() + count, count);
  all.topRows(present.fit.slopes.rows()) = present.fit.slopes;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    if (!std::isfinite(unknown.sigma)) continue;
    const double value = unknown.fromSearch(present.fit.x[i]);
    all(present.fit.slopes.rows() + i, i) = (unknown.logarithmic ? value : 1) / unknown.sigma;
  }
  return all;
}

}  // namespace

Screen::Screen(const Settled& present, const std::vector<const twin::EffectInfo*>& suspects)
    : present_{present}, slopes_{withPriors(present)}, residuals_{present.fit.residuals} {
  if (slopes_.cols() > 0) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr{slopes_};
    absorbed_ = qr.householderQ() * Eigen::MatrixXd::Identity(slopes_.rows(), qr.rank());
  } else {
    absorbed_.resize(residuals_.size(), 0);
  }

  for (const twin::EffectInfo* const effect : suspects) {
    if (has(present.effects, *effect)) continue;
    if (effect->id == "cogging") {
      for (int count = 1; count <= kMostRipples; ++count)
        directions_.push_back({{effect, {kRipple, static_cast<double>(count), 0}, 0}, {}, true});
    } else {
      for (auto& values : gridOf(unknownsOf(*effect)))
        directions_.push_back({{effect, std::move(values), 0}, {}, false});
      if (unknownsOf(*effect).empty()) continue;
    }
  }

  forEach(directions_.size(), [&](std::size_t i) {
    Direction& direction = directions_[i];
    Effects effects = present.effects;
    effects.push_back({direction.probe.effect});
    const Problem problem = problemWith(present.problem.evidence(), effects, present.numbers);
    Eigen::VectorXd x = startFrom(problem, present.problem, present.fit.x);
    const Eigen::Index rows = residuals_.size(), own = static_cast<Eigen::Index>(direction.probe.values.size());
    for (Eigen::Index k = 0; k < own; ++k) {
      const Eigen::Index at = x.size() - own + k;
      const Unknown& unknown = problem.unknowns()[static_cast<std::size_t>(at)];
      x[at] = unknown.toSearch(direction.probe.values[static_cast<std::size_t>(k)]);
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

bool Screen::suspects(std::string_view effect) const {
  return std::ranges::any_of(directions_, [&](const Direction& one) { return one.probe.effect->id == effect; });
}

Eigen::VectorXd Screen::withoutAbsorbed(Eigen::VectorXd extended) const {
  if (absorbed_.cols() > 0) extended -= absorbed_ * (absorbed_.transpose() * extended);
  return extended;
}

// The residuals are linear in how much of the probe's change is taken, up to a little more than all of it.
double Screen::promise(const Direction& direction, const Eigen::VectorXd& residuals) const {
  const auto top = direction.change.topRows(residuals.size());
  if (direction.either_way) {
    const Eigen::Matrix2d gram = direction.change.transpose() * direction.change;
    const Eigen::Vector2d along = top.transpose() * residuals;
    if (!(gram.determinant() > 1e-9)) return 0;
    return along.dot(gram.ldlt().solve(along));
  }
  const double length = direction.change.squaredNorm();
  if (!(length > 1e-9)) return 0;
  const double along = -top.col(0).dot(residuals), amount = std::clamp(along / length, 0.0, 1.3);
  return 2 * amount * along - amount * amount * length;
}

std::vector<Probe> Screen::probes() const {
  std::vector<Probe> all;
  for (const Direction& direction : directions_) {
    Probe probe = direction.probe;
    probe.promise = promise(direction, residuals_);
    if (direction.either_way && probe.promise > 0) {  // amplitude and phase that fit
      const Eigen::Matrix2d gram = direction.change.transpose() * direction.change;
      const Eigen::Vector2d along = direction.change.topRows(residuals_.size()).transpose() * residuals_;
      const Eigen::Vector2d amount = -gram.ldlt().solve(along);
      probe.values[0] = std::clamp(kRipple * amount.norm(), 1e-4, 0.15);
      probe.values[2] = std::atan2(amount[1], amount[0]);
    }
    all.push_back(std::move(probe));
  }
  std::stable_sort(all.begin(), all.end(), [](const Probe& a, const Probe& b) { return a.promise > b.promise; });
  return all;
}

double Screen::greatestPromise(const Eigen::VectorXd& residuals) const {
  double greatest = 0;
  for (const Direction& direction : directions_) greatest = std::max(greatest, promise(direction, residuals));
  return greatest;
}

}  // namespace darwinop::gap
