// Gauss-Newton along the unknowns of one effect alone: the part of the residual that other numbers explain is projected
// out, so that a step needs only as many simulations as the effect has unknowns.
#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/identify/screen.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Residuals and prior terms of the present model with one more effect.
class Along {
 public:
  Along(const FittedModel& present, const Candidate& candidate) : present_{present}, own_{candidate.values.size()} {
    Effects effects = present.effects;
    effects.push_back({candidate.effect});
    problem_.emplace(problemWith(*present.study, *present.evidence, effects, present.nuisance));
    x_ = startFrom(*problem_, present.problem, present.fit.x);
    for (std::size_t k = 0; k < own_; ++k) x_[at(k)] = unknown(k).toSearch(candidate.values[k]);
  }

  [[nodiscard]] const Unknown& unknown(std::size_t k) const {
    return problem_->unknowns()[static_cast<std::size_t>(at(k))];
  }
  [[nodiscard]] Eigen::Index at(std::size_t k) const {
    return x_.size() - static_cast<Eigen::Index>(own_) + static_cast<Eigen::Index>(k);
  }
  [[nodiscard]] double clamped(std::size_t k, double x) const {
    return std::clamp(x, unknown(k).toSearch(unknown(k).low), unknown(k).toSearch(unknown(k).high));
  }
  [[nodiscard]] Eigen::VectorXd extended(const Eigen::VectorXd& x) const {
    const auto& numbers = present_.problem.unknowns();
    Eigen::VectorXd all = Eigen::VectorXd::Zero(present_.fit.residuals.size() + present_.fit.x.size());
    problem_->residuals(x, all.head(present_.fit.residuals.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!std::isfinite(numbers[i].sigma)) continue;
      const double value = numbers[i].fromSearch(present_.fit.x[static_cast<Eigen::Index>(i)]);
      all[present_.fit.residuals.size() + static_cast<Eigen::Index>(i)] =
          (value - numbers[i].expected) / numbers[i].sigma;
    }
    return all;
  }
  [[nodiscard]] const Problem& problem() const { return *problem_; }
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }
  [[nodiscard]] std::size_t own() const { return own_; }

 private:
  const FittedModel& present_;
  std::size_t own_;
  std::optional<Problem> problem_;
  Eigen::VectorXd x_;
};

}  // namespace

RefinedStart Screen::refinedStart(const Candidate& candidate) const {
  const Along along{present_, candidate};
  const auto own = static_cast<Eigen::Index>(along.own());
  Eigen::VectorXd x = along.x(), all = along.extended(x), left = withoutAbsorbed(all);
  double size = left.squaredNorm(), damping = 1e-3;
  for (int i = 0; i < thresholds::kRefineIterations && own > 0; ++i) {
    Eigen::MatrixXd jacobian(left.size(), own);
    for (std::size_t k = 0; k < along.own(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      Eigen::VectorXd moved = x;
      double step = along.unknown(k).firstStep();
      if (along.clamped(k, x[along.at(k)] + step) < x[along.at(k)] + step) step = -step;
      moved[along.at(k)] += step;
      jacobian.col(column) = (withoutAbsorbed(along.extended(moved)) - left) / step;
    }
    const Eigen::MatrixXd gram = jacobian.transpose() * jacobian;
    const Eigen::VectorXd pull = jacobian.transpose() * left;
    double gained = 0;
    for (int attempt = 0; attempt < 3 && gained <= 0; ++attempt, damping *= 10) {
      Eigen::MatrixXd damped = gram;
      damped.diagonal() += damping * gram.diagonal() + Eigen::VectorXd::Constant(own, 1e-12);
      const Eigen::VectorXd change = -damped.ldlt().solve(pull);
      Eigen::VectorXd moved = x;
      for (std::size_t k = 0; k < along.own(); ++k)
        moved[along.at(k)] = along.clamped(k, x[along.at(k)] + change[static_cast<Eigen::Index>(k)]);
      const Eigen::VectorXd there = along.extended(moved), rest = withoutAbsorbed(there);
      if (!(rest.squaredNorm() < size)) continue;
      gained = size - rest.squaredNorm();
      x = moved, all = there, left = rest, size = rest.squaredNorm();
      damping /= 100;
    }
    if (gained < thresholds::kRefineGain * size) break;
  }

  RefinedStart refinedStart{.candidate = candidate, .x = x};
  for (std::size_t k = 0; k < along.own(); ++k)
    refinedStart.candidate.values[k] = along.unknown(k).fromSearch(x[along.at(k)]);
  Eigen::VectorXd present = Eigen::VectorXd::Zero(all.size());
  present.head(residuals_.size()) = residuals_;
  present.tail(all.size() - residuals_.size()) = all.tail(all.size() - residuals_.size());
  refinedStart.candidate.predicted_gain = withoutAbsorbed(present).squaredNorm() - size;
  if (jacobian_.cols() == 0) return refinedStart;

  const Eigen::VectorXd moves = jacobian_.colPivHouseholderQr().solve(-all);
  for (std::size_t i = 0; i < present_.problem.unknowns().size(); ++i) {
    const Unknown& number = present_.problem.unknowns()[i];
    const auto from = static_cast<Eigen::Index>(i);
    if (!std::isfinite(number.sigma)) continue;
    const double reach = thresholds::kRefinePriorSigmas * number.sigma;
    for (std::size_t j = 0; j + along.own() < along.problem().unknowns().size(); ++j)
      if (along.problem().unknowns()[j].name == number.name)
        refinedStart.x[static_cast<Eigen::Index>(j)] += std::clamp(moves[from], -reach, reach);
  }
  return refinedStart;
}

}  // namespace darwinop::gap
