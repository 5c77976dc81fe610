// The twin beside a robot: what agrees and what stands out.
#include <gmock/gmock.h>

#include "gap/live/live_robot.hpp"
#include "gap/live/thresholds.hpp"

namespace darwinop::gap::live::test {
namespace {

const std::string kStiffElbow = "[effect coulomb ArmLowerR]\nfriction = 0.12 N m\n";
constexpr double kMrad = 1e-3;

LiveReport compared(LiveRobot& robot, const twin::Model& model) {
  LiveComparison comparison{model, Support::kClamped, kPeriod};
  robot.runFor(6, comparison);
  return comparison.report();
}

TEST(LiveComparison, AnEqualModelLeavesTheStepOfTheEncoder) {
  LiveRobot robot;
  const LiveReport report = compared(robot, modelWith(""));
  EXPECT_EQ(report.state, LiveState::kComparing);
  EXPECT_EQ(report.missing, 0);
  EXPECT_EQ(report.up, (Axes{0, 1, 0}));
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_LT(report.position_rad[i].rms, kRadPerTick) << kJointTable[i].name;
    EXPECT_LT(report.load[i].rms, 0.01) << kJointTable[i].name;
    EXPECT_GT(report.position_rad[i].count, 200) << kJointTable[i].name;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(report.gyro_rad_s[i].rms, 0.004);  // the step of the register is 0.0627 rad/s; at rest it is 0
    EXPECT_LT(report.accel_m_s2[i].rms, 0.08);   // one step
  }
}

TEST(LiveComparison, AStiffElbowStandsOutAndAgreesWithAModelThatHasIt) {
  LiveRobot robot{kStiffElbow};
  const LiveReport before = compared(robot, modelWith("")), after = compared(robot, modelWith(kStiffElbow));
  EXPECT_GT(before.position_rad[kElbow].rms, 5 * kMrad);
  EXPECT_GE(before.position_rad[kElbow].worst, before.position_rad[kElbow].rms);
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_LT(after.position_rad[i].rms, kRadPerTick) << kJointTable[i].name;
    if (i == kElbow) continue;
    EXPECT_LT(before.position_rad[i].rms, kRadPerTick) << kJointTable[i].name;
  }
}

TEST(LiveComparison, ABiasOfTheGyroscopeIsInItsAxis) {
  LiveRobot robot;
  LiveComparison comparison{modelWith(""), Support::kClamped, kPeriod};
  for (double t = 0; t < 3; t += kPeriod) {
    LiveCycle cycle = robot.next();
    cycle.sensors.board.gyro[1].value += 0.2;
    comparison.take(cycle);
  }
  EXPECT_NEAR(comparison.report().gyro_rad_s[1].rms, 0.2, 0.01);
  EXPECT_NEAR(comparison.report().gyro_rad_s[1].newest, 0.2, 0.01) << "robot minus twin";
  EXPECT_LT(comparison.report().gyro_rad_s[0].rms, 0.01);
}

// Of a board that is mounted another way round (the thesis of 2013, signs of the accelerometer).
TEST(LiveComparison, AModelWithTheRobotsAccelerometerAxesHangsAsTheRobotDoes) {
  const std::string other_axes = "[imu]\naccel_axes = -1, 2, -3\n";
  for (const auto& [clamp, up] : {std::pair{"0 1 0", Axes{0, 1, 0}}, std::pair{"1 0 0", Axes{1, 0, 0}}}) {
    LiveRobot robot{other_axes, clamp};
    const LiveReport report = compared(robot, modelWith(other_axes));
    EXPECT_EQ(report.state, LiveState::kComparing);
    EXPECT_EQ(report.up, up);
    EXPECT_LT(report.position_rad[kElbow].rms, kRadPerTick);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(report.accel_m_s2[i].rms, 0.08);  // one step
  }
}

TEST(LiveComparison, ServosWithoutABoardAreComparedWithATwinThatIsUpright) {
  LiveRobot robot{kStiffElbow};
  LiveComparison comparison{modelWith(""), Support::kClamped, kPeriod};
  for (double t = 0; t < 6; t += kPeriod) {
    LiveCycle cycle = robot.next();
    cycle.sensors.board = {};
    cycle.sensors.board.absent = true;
    comparison.take(cycle);
  }
  const LiveReport report = comparison.report();
  EXPECT_EQ(report.state, LiveState::kComparing);
  EXPECT_EQ(report.up, (Axes{0, 1, 0}));
  EXPECT_GT(report.position_rad[kElbow].rms, 5 * kMrad);
  EXPECT_EQ(report.gyro_rad_s[0].count, 0);
}

TEST(LiveComparison, CatchesUpWithAMovingJoint) {
  LiveRobot robot;
  for (double t = 0; t < 2; t += kPeriod) robot.next();
  LiveComparison comparison{modelWith(""), Support::kClamped, kPeriod};
  robot.runFor(3, comparison);
  EXPECT_LT(comparison.report().position_rad[kElbow].worst, 3 * kRadPerTick);
}

TEST(LiveComparison, ARobotOnTheFloorIsComparedWithATwinOnTheFloor) {
  LiveRobot robot{"", ""};
  LiveComparison comparison{modelWith(""), Support::kFloor, kPeriod};
  robot.runFor(6, comparison);
  const LiveReport report = comparison.report();
  EXPECT_EQ(report.state, LiveState::kComparing);
  EXPECT_LT(report.position_rad[kElbow].rms, 2 * kRadPerTick);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(report.accel_m_s2[i].rms, 0.5);
}

}  // namespace
}  // namespace darwinop::gap::live::test
