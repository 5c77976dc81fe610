// Visibility of a hidden effect.
#include "gap/benchmark/body/visible_effect.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "gap/plant/registers.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kRows = 100;

/// One recording; readings of the inertial sensor are `noise` or minus that.
BodyCase resting(double noise) {
  BodyCase out;
  out.joints.model = twin::readModel(twin::findModel("darwin-op"));
  out.logs.resize(1);
  for (auto* sensor : {&out.logs[0].gyro_rad_s, &out.logs[0].accel_m_s2})
    for (auto& axis : *sensor)
      for (std::size_t row = 0; row < kRows; ++row) axis.push_back(row % 2 == 0 ? noise : -noise);
  out.joints.logs.resize(kJoints);
  for (Trajectory& log : out.joints.logs) log.position_rad.assign(kRows, 0.1);
  return out;
}

TEST(VisibleEffect, ShowsByTheWorstHalfSecondOfAJoint) {
  const BodyCase without = resting(0.01), again = resting(-0.01);
  const double noise = readingSigma(without.joints.model.servo);
  BodyCase with = without;
  EXPECT_LT(worstDifference(with, without, again, {0}), 1e-9);
  for (std::size_t row = 40; row < 71; ++row) with.joints.logs[7].position_rad[row] += 5 * noise;
  const double worst = worstDifference(with, without, with, {0});
  EXPECT_NEAR(worst, 5, 1e-6);
  EXPECT_EQ(worstDifference(with, without, with, {}), 0) << "of no log";
}

TEST(VisibleEffect, IsComparedWithHowARobotDiffersFromItself) {
  const BodyCase without = resting(0.01);
  BodyCase with = without, again = without;
  for (std::size_t row = 40; row < 71; ++row) {
    with.logs[0].gyro_rad_s[1][row] += 0.1;
    again.logs[0].gyro_rad_s[1][row] += row % 2 == 0 ? 0.1 : 0.3;
  }
  again.logs[0].gyro_rad_s[1][0] += 0.2;
  EXPECT_LT(worstDifference(with, without, again, {0}), 3) << "another walk of the same robot is as far off";
}

TEST(VisibleEffect, AReadingThatIsMissingShowsNothing) {
  const BodyCase without = resting(0.01);
  BodyCase with = without;
  with.joints.logs[3].position_rad.assign(kRows, std::numeric_limits<double>::quiet_NaN());
  EXPECT_LT(worstDifference(with, without, resting(-0.01), {0}), 1e-9);
}

}  // namespace
}  // namespace darwinop::gap
