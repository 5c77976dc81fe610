// Readings of a moving inertial sensor: of the model's own deviations and of those that were found.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "gap/body/standing_robot.hpp"
#include "gap/plant/body/model_with.hpp"
#include "gap/plant/body/stance_rates.hpp"

namespace darwinop::gap {
namespace {

/// Model and deviation have all that both can have; axes and scales are such that their order matters.
twin::Model deviatingModel() {
  twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  twin::ImuSettings& imu = model.imu;
  imu.gyro_bias_rad_s = {0.2, 0, -0.1}, imu.gyro_scale = {1.1, 1, 0.9}, imu.gyro_axes = {2, -1, 3};
  imu.accel_bias_m_s2 = {0.5, 0, 0.2}, imu.accel_scale = {1, 1.05, 1}, imu.accel_axes = {1, 3, -2};
  imu.mounting_rad = {0.1, 0, 0.05};
  return model;
}

ImuDeviation found() {
  ImuDeviation out;
  out.gyro.scale = {-1, 1.2, 1}, out.gyro.bias = {0, 0.05, 0};
  out.gyro.map << 0, 0, 1, 1, 0, 0, 0, -1, 0;
  out.accel.scale = {1, 0.9, 1}, out.accel.bias = {0, 0, 0.3};
  out.accel.map << -1, 0, 0, 0, 1, 0, 0, 0, 1;
  out.accel.rotation = {0, 0.2, 0};
  out.delay_s = 0.003, out.range_rad_s = 1;
  return out;
}

BodyCase squattingRobot(const twin::Model& model) {
  BodyCase out;
  out.joints.model = model;
  addRecording(out, BodySetup::kFloor, 40, false);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    out.joints.logs[joint].position_rad = out.joints.logs[joint].goal_rad;
  return out;
}

MovingImu::Readings simulated(const BodyCase& given, const ImuDeviation& deviation) {
  return MovingImu{given.joints.model}.of(rollOut(given, 0, {.robot = {bodyBaselineOf(given), {}}, .floor = {}}),
                                          deviation);
}

TEST(MovingImu, ADeviationThatWasFoundMeansTheSameOnceTheModelHasIt) {
  const twin::Model model = deviatingModel();
  const BodyCase before = squattingRobot(model);
  const FloorHypothesis robot{.robot = {bodyBaselineOf(before), {}}, .floor = {}};
  const ModelWith with = modelWith(model, robot, found());
  EXPECT_TRUE(with.conflicts.empty());
  const BodyCase after = squattingRobot(with.model);
  const MovingImu::Readings is = simulated(before, found()), wanted = simulated(after, {});
  EXPECT_LT((is.gyro_rad_s - wanted.gyro_rad_s).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((is.accel_m_s2 - wanted.accel_m_s2).cwiseAbs().maxCoeff(), 1e-6);
  const std::array<StanceRates, 2> feet = stanceRates(before, 0), same = stanceRates(after, 0);
  for (std::size_t foot = 0; foot < 2; ++foot)
    EXPECT_LT((MovingImu{model}.of(feet[foot].trace, found()).gyro_rad_s -
               MovingImu{with.model}.of(same[foot].trace, {}).gyro_rad_s)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6);
}

TEST(MovingImu, OfATrunkThatStandsReadsWhatTheRestingOneDoes) {
  const twin::Model model = deviatingModel();
  BodyCase given = squattingRobot(model);
  for (Trajectory& joint : given.joints.logs) joint.goal_rad.assign(joint.rows(), 0);  // straight legs: level
  const MovingImu::Readings is = simulated(given, found());
  const RestingImu resting{model};
  const Eigen::Index last = is.gyro_rad_s.rows() - 1;
  EXPECT_LT((is.gyro_rad_s.row(last).transpose() - resting.reading(ImuSensor::kGyro, {0, 1, 0}, found().gyro)).norm(),
            0.02);
  EXPECT_LT((is.accel_m_s2.row(last).transpose() - resting.reading(ImuSensor::kAccelerometer, {0, 1, 0}, found().accel))
                .norm(),
            0.1);
}

TEST(MovingImu, ASensorIsLateSlowLimitedAndTurnedAsItsDeviationSays) {
  const MovingImu imu{twin::readModel(twin::findModel("darwin-op"))};
  constexpr Eigen::Index kCycles = 200;
  FloorTrace trace{.position_rad = {},
                   .gyro_rad_s = Eigen::MatrixX3d::Zero(kCycles, 3),
                   .accel_m_s2 = Eigen::MatrixX3d::Zero(kCycles, 3),
                   .cycle_of_row = {99, 110, 120, 199}};
  trace.gyro_rad_s.bottomRows(kCycles - 100).col(0).setConstant(1);  // from cycle 100 on
  ImuDeviation deviation;
  deviation.delay_s = 0.015;
  EXPECT_EQ(imu.of(trace, deviation).gyro_rad_s(1, 0), 0);
  EXPECT_EQ(imu.of(trace, deviation).gyro_rad_s(2, 0), 1);
  deviation.delay_s = 0, deviation.lowpass_s = 0.02;
  EXPECT_NEAR(imu.of(trace, deviation).gyro_rad_s(2, 0), 1 - std::exp(-21. / 20), 1e-9);
  deviation.lowpass_s = 0, deviation.range_rad_s = 0.4;
  EXPECT_EQ(imu.of(trace, deviation).gyro_rad_s(3, 0), 0.4);
  deviation.range_rad_s = 30, deviation.gyro.scale = {1.2, 1, 1}, deviation.gyro.bias = {0, 0.1, 0};
  EXPECT_NEAR(imu.of(trace, deviation).gyro_rad_s(3, 0), 1.2, 1e-12);
  EXPECT_NEAR(imu.of(trace, deviation).gyro_rad_s(3, 1), 0.1, 1e-12);
  deviation = {};
  deviation.accel.rotation = {0, 0.1, 0};  // about the trunk's up: the board's other axes see a part of a rate
  const Eigen::RowVector3d turned = imu.of(trace, deviation).gyro_rad_s.row(3);
  EXPECT_NEAR(turned.norm(), 1, 1e-12);
  EXPECT_NEAR(turned[0], std::cos(0.1), 1e-9);
}

}  // namespace
}  // namespace darwinop::gap
