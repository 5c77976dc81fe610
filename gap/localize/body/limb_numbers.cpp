// Numbers of a limb within their priors: where they are linearized, and a step towards the most probable ones.
#include <algorithm>
#include <cmath>

#include "gap/fit/discrepancy.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/localize/body/limb_residuals.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

void LimbResiduals::addPriors(const BodyHypothesis& about) {
  if (nuisances_.empty()) return;
  const BodyHypothesis there = moved(about, numbers_);
  const Eigen::VectorXd here = simulated(there, nullptr);
  const Eigen::Index runs = directions_.cols();
  forgetUnmeasured(measured_, directions_);
  modes_of_noise_ = NoiseModes{directions_};
  directions_.conservativeResize(Eigen::NoChange, runs + numbers_.size());
  forEach(nuisances_.size(), [&](std::size_t i) {
    const auto k = static_cast<Eigen::Index>(i);
    const bool is_replaced = isReplaced(i, about);
    BodyHypothesis stepped = there;
    if (is_replaced)
      nuisances_[i].move(stepped, thresholds::kPriorStep);
    else
      stepped = moved(about, numbers_ + thresholds::kPriorStep * Eigen::VectorXd::Unit(numbers_.size(), k));
    directions_.col(runs + k) = (simulated(stepped, nullptr) - here).cwiseQuotient(sigma_) / thresholds::kPriorStep;
  });
  directions_ = directions_.unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
}

bool LimbResiduals::isReplaced(std::size_t nuisance, const BodyHypothesis& by) const {
  return nuisances_[nuisance].is_replaced && nuisances_[nuisance].is_replaced(by);
}

BodyHypothesis LimbResiduals::moved(BodyHypothesis hypothesis, const Eigen::VectorXd& numbers) const {
  for (std::size_t i = 0; i < nuisances_.size(); ++i)
    if (const double by = numbers[static_cast<Eigen::Index>(i)]; by != 0 && !isReplaced(i, hypothesis))
      nuisances_[i].move(hypothesis, by);
  return hypothesis;
}

Eigen::VectorXd LimbResiduals::inSigmasOf(const BodyHypothesis& exact) const {
  return inSigmas(measured_ - simulated(exact, nullptr), measured_, sigma_);
}

// Where r(a) are the residuals with numbers a, D their slopes at these numbers b, and a has a variance of 1:
// r(b) + D b has the mean 0, and the variance of noise and D D'.
Eigen::VectorXd LimbResiduals::scaled(const BodyHypothesis& hypothesis) const {
  Eigen::VectorXd out = inSigmasOf(moved(hypothesis, numbers_));
  for (std::size_t i = 0; i < nuisances_.size(); ++i)
    if (const auto k = static_cast<Eigen::Index>(i); numbers_[k] != 0 && !isReplaced(i, hypothesis))
      out += numbers_[k] * directions_.col(directions_.cols() - numbers_.size() + k);
  return out;
}

double LimbResiduals::costOf(const BodyHypothesis& about, const Eigen::VectorXd& numbers) const {
  const Eigen::VectorXd z = modes_of_noise_.whitened(inSigmasOf(moved(about, numbers)));
  return z.unaryExpr([](double one) { return softened(one); }).squaredNorm() + numbers.squaredNorm();
}

std::optional<Eigen::VectorXd> LimbResiduals::betterNumbers(const BodyHypothesis& about) const {
  if (nuisances_.empty()) return {};
  Eigen::MatrixXd jacobian = directions_.rightCols(numbers_.size());
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i) jacobian.col(i) = modes_of_noise_.whitened(jacobian.col(i));
  const Eigen::VectorXd here = modes_of_noise_.whitened(inSigmasOf(moved(about, numbers_)));
  const Eigen::VectorXd target = absorb(here + jacobian * numbers_, jacobian).moves;
  const double cost = costOf(about, numbers_);
  for (double share = 1; share >= thresholds::kLeastShareOfAStep; share /= 2) {
    Eigen::VectorXd next = numbers_ + share * (target - numbers_);
    if (costOf(about, next) < cost) return next;
  }
  return {};
}

std::unique_ptr<LimbResiduals> LimbResiduals::withoutReleases(const BodyHypothesis& about) const {
  if (nuisances_.empty()) return nullptr;
  std::vector<std::size_t> logs;
  std::ranges::copy_if(logs_, std::back_inserter(logs), [&](std::size_t log) {
    return std::ranges::all_of(limb_, [&](const Link& link) {
      const auto& torque_on = given_.joint(log, static_cast<std::size_t>(link.joint)).torque_on;
      return std::ranges::find(torque_on, 0) == torque_on.end();
    });
  });
  if (logs.empty() || logs.size() == logs_.size()) return nullptr;
  return std::make_unique<LimbResiduals>(given_, std::move(logs), limb_, about, numbers_);
}

std::unique_ptr<LimbResiduals> LimbResiduals::withNumbersOf(std::string_view effect, const std::vector<Joint>& at,
                                                            const std::vector<double>& values,
                                                            const BodyHypothesis& about) const {
  Eigen::VectorXd numbers = numbers_;
  for (std::size_t i = 0; i < nuisances_.size(); ++i)
    if (nuisances_[i].effect == effect && std::ranges::find(at, nuisances_[i].at) != at.end())
      numbers[static_cast<Eigen::Index>(i)] = nuisances_[i].sigmas_of(values);
  return this->about(about, std::move(numbers));
}

}  // namespace darwinop::gap
