// Removes from residuals what baseline numbers can explain within their priors: that is not a gap.
#pragma once

#include <Eigen/Core>

namespace darwinop::gap {

struct Absorption {
  Eigen::VectorXd left;   // of the residuals
  Eigen::VectorXd moves;  // of the numbers, in prior standard deviations
};

/// `z`: whitened residuals. `jacobian`: their decrease per prior standard deviation of each number. Minimises robust
/// cost plus prior.
Absorption absorb(const Eigen::VectorXd& z, const Eigen::MatrixXd& jacobian);

/// Significance of the moves together, in standard deviations of a normal distribution.
double significanceOf(const Eigen::VectorXd& moves);
/// The same of a sum of `count` independent squares, and of a chance; at most 37, and 0 for what is more likely than
/// not.
double sigmasOfChiSquared(double sum, double count);
double sigmasOfChance(double chance);

}  // namespace darwinop::gap
