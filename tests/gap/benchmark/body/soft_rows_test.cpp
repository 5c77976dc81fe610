// A mass of 2 kg on one degree of freedom, and on three with a contact.
#include "gap/benchmark/body/soft_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace darwinop::gap {
namespace {

constexpr double kMass = 2, kStep = 0.001;

SoftRow frictionOf(double limit) {
  return {.direction = Eigen::VectorXd::Ones(1), .stiffness = 1e5, .damping = 100, .limit = limit};
}

/// Speed after 0.5 s of a constant force.
double pushed(double force, double limit) {
  SoftRow row = frictionOf(limit);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(1);
  for (int i = 0; i < 500; ++i) {
    std::vector<SoftRow> rows{row};
    v = stepped(Eigen::MatrixXd::Constant(1, 1, kMass), Eigen::VectorXd::Zero(1), v,
                Eigen::VectorXd::Constant(1, force), kStep, rows);
    row.bend = rows[0].bend_new;
  }
  return v[0];
}

TEST(SoftRows, AMassRestsUnderLessThanItsFrictionAndAcceleratesByTheRest) {
  EXPECT_NEAR(pushed(0.9, 1), 0, 1e-6);
  EXPECT_NEAR(pushed(3, 1), (3 - 1) / kMass * 0.5, 0.01);
}

/// Sideways speed, and force of the floor, after 0.5 s on a contact with friction 0.5.
std::pair<double, double> onFloor(double sideways, double upward) {
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();
  double height = 0, force = 0;
  Eigen::VectorXd v = Eigen::VectorXd::Zero(3);
  for (int i = 0; i < 500; ++i) {
    std::vector<SoftRow> rows;
    if (height <= 0) {
      rows.push_back({.direction = Eigen::Vector3d::UnitZ(),
                      .stiffness = 1e5,
                      .damping = 900,
                      .bend = height,
                      .only_pushes = true});
      for (int axis = 0; axis < 2; ++axis)
        rows.push_back({.direction = Eigen::Vector3d::Unit(axis),
                        .stiffness = 1e5,
                        .damping = 900,
                        .bend = anchor[axis],
                        .limit = 0.5,
                        .normal = 0});
    }
    v = stepped(kMass * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), v,
                Eigen::Vector3d{sideways, 0, upward - 9.81 * kMass}, kStep, rows);
    height += kStep * v[2];
    force = rows.empty() ? 0 : rows[0].force;
    if (!rows.empty()) anchor = {rows[1].bend_new, rows[2].bend_new};
  }
  return {v[0], force};
}

TEST(SoftRows, AContactCarriesTheWeightAndHoldsWithinItsCone) {
  const auto [at_rest, weight] = onFloor(9, 0);
  EXPECT_NEAR(weight, 9.81 * kMass, 0.01);
  EXPECT_NEAR(at_rest, 0, 1e-5);
  EXPECT_NEAR(onFloor(13, 0).first, (13 - 0.5 * 9.81 * kMass) / kMass * 0.5, 0.02);
}

TEST(SoftRows, AContactDoesNotPull) {
  EXPECT_EQ(onFloor(0, 30).second, 0);
}

}  // namespace
}  // namespace darwinop::gap
