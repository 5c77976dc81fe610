// What the priors of the numbers leave of residuals: a number that is a little off inside its prior is no gap.
#pragma once

#include <Eigen/Core>

namespace darwinop::gap {

struct Absorption {
  Eigen::VectorXd left;   // of the residuals
  Eigen::VectorXd moves;  // of the numbers, in sigmas of their priors
};

/// `z`: residuals in standard deviations. `slopes`: what each number takes from them per standard deviation of its
/// prior. Moves the numbers to where robust cost and prior are least.
Absorption absorb(const Eigen::VectorXd& z, const Eigen::MatrixXd& slopes);

/// What the moves themselves say, in standard deviations of a normal distribution: numbers that lie inside their priors
/// do not move that far together.
double significanceOf(const Eigen::VectorXd& moves);

}  // namespace darwinop::gap
