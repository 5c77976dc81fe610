// What errors of many samples have in common, as a few modes: residuals along them count as what noise, chaos and
// priors explain, not once a sample.
#pragma once

#include <Eigen/Core>

namespace darwinop::gap {

class NoiseModes {
 public:
  NoiseModes() = default;
  /// A column for each error of one standard deviation, in standard deviations of the samples.
  explicit NoiseModes(const Eigen::MatrixXd& directions);

  /// Residuals, or derivatives of them, whose variance is one in each direction. Linear.
  [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& scaled) const;

 private:
  Eigen::MatrixXd modes_;   // orthonormal
  Eigen::VectorXd shrink_;  // what whitening takes away of each
};

/// Residual of each column after ridge regression on the others, with unit prior variance of the coefficients: what one
/// more run of an ensemble is expected to add outside of the span of the existing ones.
Eigen::MatrixXd notSpannedByOthers(const Eigen::MatrixXd& directions);

/// Residuals over their standard deviations. Not measured: 0. Not simulated: impossible.
Eigen::VectorXd inSigmas(const Eigen::VectorXd& residuals, const Eigen::VectorXd& measured,
                         const Eigen::VectorXd& sigma);
/// Clears the rows of samples that were not measured.
void forgetUnmeasured(const Eigen::VectorXd& measured, Eigen::MatrixXd& directions);

}  // namespace darwinop::gap
