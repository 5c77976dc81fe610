// Leave-one-out residuals of a small ensemble.
#include "gap/localize/body/noise_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/random.hpp"

namespace darwinop::gap {
namespace {

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, double by) {
  Rng rng{3};
  Eigen::MatrixXd out(rows, columns);
  for (double& one : out.reshaped()) one = by * rng.normal();
  return out;
}

TEST(NoiseModes, RunsThatDifferInOneWaySpanEachOther) {
  const Eigen::MatrixXd runs = drawn(50, 1, 10) * Eigen::RowVectorXd::LinSpaced(6, 1, 2);
  EXPECT_LT(notSpannedByOthers(runs).colwise().norm().maxCoeff(), 0.02 * runs.colwise().norm().minCoeff());
}

TEST(NoiseModes, ARunThatIsLikeNoOtherIsNotSpanned) {
  const Eigen::MatrixXd runs = 10 * Eigen::MatrixXd::Identity(50, 6);
  EXPECT_TRUE(notSpannedByOthers(runs).isApprox(runs));
}

// Against the explicit solution for each column.
TEST(NoiseModes, WhatIsLeftIsThatOfARidgeRegressionOnTheOthers) {
  const Eigen::MatrixXd runs = drawn(30, 5, 0.7), left = notSpannedByOthers(runs);
  for (Eigen::Index k = 0; k < runs.cols(); ++k) {
    Eigen::MatrixXd others = runs;
    others.col(k).setZero();
    const Eigen::MatrixXd normal = others.transpose() * others + Eigen::MatrixXd::Identity(5, 5);
    const Eigen::VectorXd weights = normal.ldlt().solve(others.transpose() * runs.col(k));
    EXPECT_TRUE(left.col(k).isApprox(runs.col(k) - others * weights)) << k;
  }
}

}  // namespace
}  // namespace darwinop::gap
