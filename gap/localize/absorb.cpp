#include "gap/localize/absorb.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "gap/fit/problem.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
Absorption absorb(const Eigen::VectorXd& z, const Eigen::MatrixXd& jacobian) {
  Absorption out{.left = z, .moves = Eigen::VectorXd::Zero(jacobian.cols())};
  if (jacobian.cols() == 0) return out;
  for (int round = 0; round < thresholds::kAbsorptionRounds; ++round) {
    // Weights of the pseudo-Huber cost; the prior weighs 1.
    const Eigen::VectorXd weight = (1 + (out.left.array() / thresholds::kRobustSigmas).square()).rsqrt();
    Eigen::MatrixXd normal = jacobian.transpose() * weight.asDiagonal() * jacobian;
    normal.diagonal().array() += 1;
    const Eigen::VectorXd right = jacobian.transpose() * (weight.array() * z.array()).matrix();
    out.moves = normal.ldlt().solve(right).cwiseMax(-thresholds::kAbsorbedSigmas).cwiseMin(thresholds::kAbsorbedSigmas);
    out.left = z - jacobian * out.moves;
  }
  return out;
}

double significanceOf(const Eigen::VectorXd& moves) {
  return moves.size() == 0 ? 0 : sigmasOfChiSquared(moves.squaredNorm(), static_cast<double>(moves.size()));
}

double sigmasOfChiSquared(double sum, double count) {
  const double chance = boost::math::cdf(boost::math::complement(boost::math::chi_squared{count}, sum));
  return sigmasOfChance(chance);
}

double sigmasOfChance(double chance) {
  return boost::math::quantile(boost::math::complement(boost::math::normal{}, std::clamp(chance, 1e-300, 0.5)));
}

}  // namespace darwinop::gap
