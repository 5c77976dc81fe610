// Table of signal, place and block, from recordings that the test writes.
#include <gmock/gmock.h>

#include "gap/body/moving_robot.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

BodyTable tableOf(const SyntheticRobot& robot) {
  const BodyCase c = BodyTexts{robot}.read();
  return localize(c, RestingImu{c.joints.model});
}

std::vector<std::string> openSignals(const BodyTable& table) {
  std::vector<std::string> open;
  for (const BodyRow& row : table.rows)
    if (row.open) open.push_back(row.signal);
  return open;
}

const BodyRow& rowOf(const BodyTable& table, const std::string& signal) {
  return *std::ranges::find(table.rows, signal, &BodyRow::signal);
}

TEST(BodyLocate, ARobotLikeItsModelHasNothingOpen) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SyntheticRobot robot;
    robot.seed = seed;
    robot.limp_joint = index(Joint::kNeck);
    robot.p_gain_late = 1;
    const BodyTable table = tableOf(robot);
    EXPECT_THAT(openSignals(table), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(table.rows.size(), 2 * kJoints + 6);
  }
}

TEST(BodyLocate, ALimitedDutyOpensTheControllerOfItsJointAlone) {
  SyntheticRobot robot;
  robot.duty = [](std::size_t joint, double duty) {
    return joint == index(Joint::kLegUpperL) ? std::clamp(duty, -0.1, 0.1) : duty;
  };
  const BodyTable table = tableOf(robot);
  EXPECT_THAT(openSignals(table), ElementsAre("LegUpperL.load"));
  const BodyRow& row = table.rows.front();
  EXPECT_EQ(row.block, Block::kController);
  EXPECT_EQ(row.place.name, "LegUpperL");
  EXPECT_GT(row.floors, 3);
  EXPECT_LE(row.t1_s - row.t0_s, 0.51);
}

TEST(BodyLocate, ASmallGainErrorInAllJointsOpensAllUnlessThePriorAllowsIt) {
  SyntheticRobot robot;
  robot.duty = [](std::size_t, double duty) { return 1.1 * duty; };
  EXPECT_EQ(tableOf(robot).open(), kJoints);
  robot.trust = R"({"servo.duty_per_kp": 0.08})";
  EXPECT_EQ(tableOf(robot).open(), 0u);
}

TEST(BodyLocate, APriorOfAllServosHidesNoJoint) {
  SyntheticRobot robot;
  robot.trust = R"({"servo.duty_per_kp": 0.05})";
  robot.duty = [](std::size_t joint, double duty) { return joint == index(Joint::kHead) ? 0.6 * duty : duty; };
  EXPECT_THAT(openSignals(tableOf(robot)), ElementsAre("Head.load"));
}

TEST(BodyLocate, ASupplyThatSagsAtOneServoOpensItsSupply) {
  SyntheticRobot robot;
  robot.servo_sag_v = 0.3;
  const BodyTable table = tableOf(robot);
  EXPECT_THAT(openSignals(table), ElementsAre(std::string{kJointTable[3].name} + ".voltage"));
  EXPECT_EQ(table.rows.front().block, Block::kSupply);
}

TEST(BodyLocate, ABiasOpensItsAxisUnlessThePriorAllowsIt) {
  SyntheticRobot robot;
  robot.gyro_bias = {0, 0.06, 0};
  const BodyTable table = tableOf(robot);
  EXPECT_THAT(openSignals(table), ElementsAre("gyro.y"));
  EXPECT_NEAR(rowOf(table, "gyro.y").size, 0.06, 0.005);
  EXPECT_EQ(rowOf(table, "gyro.y").block, Block::kSensor);
  robot.trust = R"({"imu.gyro_bias_rad_s": 0.03})";
  EXPECT_THAT(openSignals(tableOf(robot)), IsEmpty());
}

TEST(BodyLocate, AnAccelerometerTurnedInTheTrunkOpensTheTwoAxesThatTurn) {
  SyntheticRobot robot;
  robot.yaw_rad = 0.05;
  EXPECT_THAT(openSignals(tableOf(robot)), UnorderedElementsAre("accelerometer.x", "accelerometer.z"));
}

TEST(BodyLocate, AJointThatNeverAnswersIsNotTestedAndTheOthersAre) {
  SyntheticRobot robot;
  robot.absent_joint = index(Joint::kNeck);
  const BodyCase given = BodyTexts{robot}.read();
  const std::string absent = absentText(given);
  EXPECT_THAT(absent, testing::StartsWith("Neck:"));
  EXPECT_THAT(checkData(given).cannot_show, testing::Contains(absent));
  EXPECT_THAT(checkData(given).logs.front().unmoved, IsEmpty());
  const BodyTable table = tableOf(robot);
  EXPECT_THAT(openSignals(table), IsEmpty());
  EXPECT_EQ(table.rows.size(), 2 * (kJoints - 1) + 6);
  EXPECT_THAT(table.not_tested, testing::Contains(absent));
}

TEST(BodyLocate, ALimbWithAJointThatNeverAnswersIsNotSimulated) {
  BodyCase given = movingRobot(shippedRobot());
  given.is_absent[index(Joint::kNeck)] = true;
  for (std::size_t log = 0; log < given.logs.size(); ++log)
    std::ranges::fill(given.joints.logs[log * kJoints + index(Joint::kNeck)].position_rad, std::nan(""));
  const BodyTable table = localize(given, RestingImu{given.joints.model}, ClampedRobot{given});
  EXPECT_THAT(openSignals(table), IsEmpty());
  const auto is_plant = [](const BodyRow& row) { return row.block == Block::kPlant; };
  EXPECT_EQ(std::ranges::count_if(table.rows, is_plant), static_cast<std::ptrdiff_t>(kJoints) - 2) << "nor the head";
}

TEST(BodyLocate, ABatteryWithAResistanceSuppliesWhatTheBoardMeasures) {
  for (const double resistance_ohm : {0.0, 0.5}) {
    BodyCase given = BodyTexts{}.read();
    given.joints.model.body.battery_resistance_ohm = resistance_ohm;
    for (BodyLog& log : given.logs) log.board_v.assign(log.rows(), log.battery_v - 0.3);
    for (Trajectory& joint : given.joints.logs)
      for (double& volt : joint.volt_v) volt -= 0.3;
    const BodyTable table = localize(given, RestingImu{given.joints.model});
    EXPECT_EQ(table.open(), resistance_ohm > 0 ? 0 : kJoints) << resistance_ohm;
    EXPECT_EQ(ClampedRobot{given}.baseline().has_board_supply, resistance_ohm > 0);
  }
}

TEST(BodyLocate, ServosThatSeeAnotherMomentOfTheSupplyThanTheBoardAreClosedAndOneThatSagsIsNot) {
  for (const double sag_v : {0.0, 0.5}) {
    SyntheticRobot robot;
    robot.servo_sag_v = sag_v;
    BodyCase given = BodyTexts{robot}.read();
    given.joints.model.body.battery_resistance_ohm = 0.5;
    for (BodyLog& log : given.logs) log.board_v.assign(log.rows(), log.battery_v);
    for (Trajectory& joint : given.joints.logs)
      for (std::size_t row = 0; row < joint.rows(); ++row) joint.volt_v[row] -= row % 16 == 0 ? 0.2 : 0;
    const BodyTable table = localize(given, RestingImu{given.joints.model});
    if (sag_v == 0)
      EXPECT_THAT(openSignals(table), IsEmpty());
    else
      EXPECT_THAT(openSignals(table), ElementsAre(std::string{kJointTable[3].name} + ".voltage"));
  }
}

TEST(BodyLocate, WithoutAClampedLogTheSensorIsNotTested) {
  SyntheticRobot robot;
  robot.gyro_bias = {0, 1, 0};
  BodyCase c = BodyTexts{robot}.read();
  for (BodyLog& log : c.logs) log.setup = BodySetup::kFloor, log.up.reset();
  const BodyTable table = localize(c, RestingImu{c.joints.model});
  EXPECT_EQ(table.rows.size(), 2 * kJoints);
  EXPECT_EQ(table.open(), 0u);
}

TEST(BodyLocate, AHeldOutLogIsNotLookedAt) {
  BodyCase c = BodyTexts{}.read();
  for (std::vector<double>& axis : c.logs[5].gyro_rad_s) axis.assign(axis.size(), 3.0);
  for (double& load : c.joints.logs[5 * kJoints].load) load = 0.9;
  EXPECT_EQ(localize(c, RestingImu{c.joints.model}).open(), 0u);
}

}  // namespace
}  // namespace darwinop::gap
