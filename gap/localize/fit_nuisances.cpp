#include "gap/localize/fit_nuisances.hpp"

#include <algorithm>
#include <cmath>

#include "gap/fit/problem.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// All logs of one cut under the baseline with its numbers moved inside their priors.
class Mover {
 public:
  Mover(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
        const Hypothesis& hypothesis, std::vector<Unknown> numbers, std::vector<BlockResiduals>& samples)
      : cut_{cut},
        given_{given},
        logs_{logs},
        hypothesis_{hypothesis},
        numbers_{std::move(numbers)},
        samples_{samples} {
    for (const BlockResiduals& one : samples) begin_.push_back(begin_.back() + one.z.size());
  }

  /// Subtracts from z the part that the numbers explain; returns their moves in sigmas.
  Eigen::VectorXd move() {
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(count()), best_z = columns({moves}).col(0);
    Eigen::VectorXd best = moves, z = best_z;
    double least = costAt(z, moves);
    for (int step = 0; step < thresholds::kNuisanceSteps; ++step) {
      const Eigen::MatrixXd jacobian = jacobianAt(moves, z);
      if (jacobian.isZero()) break;
      moves = absorb(z + jacobian * moves, jacobian).moves;
      z = columns({moves}).col(0);
      if (const double cost = costAt(z, moves); cost < least) least = cost, best = moves, best_z = z;
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].z = best_z.segment(begin_[i], samples_[i].z.size());
    return best;
  }

 private:
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(numbers_.size()); }

  static double costAt(const Eigen::VectorXd& z, const Eigen::VectorXd& moves) {
    return z.unaryExpr(&costOf).sum() + moves.squaredNorm();
  }

  /// Residuals over sigma with the numbers moved, a column for each set of moves.
  [[nodiscard]] Eigen::MatrixXd columns(const std::vector<Eigen::VectorXd>& sets) const {
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(begin_.back(), static_cast<Eigen::Index>(sets.size()));
    forEach(sets.size() * logs_.size(), [&](std::size_t task) {
      const std::size_t set = task / logs_.size(), i = task % logs_.size();
      std::vector<double> x;
      for (std::size_t k = 0; k < numbers_.size(); ++k) {
        const double value = numbers_[k].expected + sets[set][static_cast<Eigen::Index>(k)] * numbers_[k].sigma;
        // Three sigmas of a number that is known to a half would be a negative mass.
        x.push_back(numbers_[k].toSearch(std::clamp(value, numbers_[k].low, numbers_[k].high)));
      }
      const BlockResiduals there = cut_(given_.logs[logs_[i]], applied(hypothesis_, numbers_, x.data()));
      for (Eigen::Index k = 0; k < there.residual.size(); ++k)
        if (!std::isnan(there.residual[k]))
          z(begin_[i] + k, static_cast<Eigen::Index>(set)) = there.residual[k] / samples_[i].sigma[k];
    });
    return z;
  }

  /// Decrease of z per sigma of each number.
  [[nodiscard]] Eigen::MatrixXd jacobianAt(const Eigen::VectorXd& moves, const Eigen::VectorXd& z) const {
    std::vector<Eigen::VectorXd> sets(numbers_.size(), moves);
    for (std::size_t k = 0; k < sets.size(); ++k)
      sets[k][static_cast<Eigen::Index>(k)] += thresholds::kNuisanceStepSigmas;
    return (z.replicate(1, count()) - columns(sets)) / thresholds::kNuisanceStepSigmas;
  }

  const BlockResidualFunction& cut_;
  const Case& given_;
  const std::vector<std::size_t>& logs_;
  const Hypothesis& hypothesis_;
  const std::vector<Unknown> numbers_;
  std::vector<BlockResiduals>& samples_;
  std::vector<Eigen::Index> begin_{0};
};

}  // namespace

Eigen::VectorXd fitNuisances(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                             const Hypothesis& hypothesis, const std::vector<Unknown>& numbers,
                             std::vector<BlockResiduals>& samples) {
  return Mover{cut, given, logs, hypothesis, numbers, samples}.move();
}

}  // namespace darwinop::gap
