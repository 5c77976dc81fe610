#include "gap/localize/body/noise_modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "gap/thresholds.hpp"

namespace darwinop::gap {

NoiseModes::NoiseModes(const Eigen::MatrixXd& directions) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram{directions.transpose() * directions};
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < gram.eigenvalues().size(); ++i)
    if (gram.eigenvalues()[i] > thresholds::kSmallestNoiseMode) kept.push_back(i);
  modes_.resize(directions.rows(), static_cast<Eigen::Index>(kept.size()));
  shrink_.resize(modes_.cols());
  for (Eigen::Index k = 0; k < modes_.cols(); ++k) {
    const double variance = gram.eigenvalues()[kept[static_cast<std::size_t>(k)]];
    modes_.col(k) = directions * gram.eigenvectors().col(kept[static_cast<std::size_t>(k)]) / std::sqrt(variance);
    shrink_[k] = 1 - 1 / std::sqrt(1 + variance);
  }
}

Eigen::VectorXd NoiseModes::whitened(const Eigen::VectorXd& scaled) const {
  return scaled - modes_ * shrink_.cwiseProduct(modes_.transpose() * scaled);
}

// A column less its ridge regression on the others: by the inverse of a block matrix, a column of the inverse of
// 1 + gram over its diagonal.
Eigen::MatrixXd notSpannedByOthers(const Eigen::MatrixXd& directions) {
  Eigen::MatrixXd gram = directions.transpose() * directions;
  gram.diagonal().array() += 1;
  const Eigen::MatrixXd inverse = gram.ldlt().solve(Eigen::MatrixXd::Identity(gram.rows(), gram.cols()));
  return directions * (inverse * inverse.diagonal().cwiseInverse().asDiagonal());
}

Eigen::VectorXd inSigmas(const Eigen::VectorXd& residuals, const Eigen::VectorXd& measured,
                         const Eigen::VectorXd& sigma) {
  Eigen::VectorXd out = residuals;
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    if (std::isnan(measured[i]))
      out[i] = 0;
    else
      out[i] = std::isfinite(out[i]) ? out[i] / sigma[i] : thresholds::kImpossibleSigmas;
  }
  return out;
}

void forgetUnmeasured(const Eigen::VectorXd& measured, Eigen::MatrixXd& directions) {
  for (Eigen::Index i = 0; i < measured.size(); ++i)
    if (std::isnan(measured[i])) directions.row(i).setZero();
}

}  // namespace darwinop::gap
