// Recordings on the floor: roll-out, sensors in motion, and effects of floor, trunk and gyroscope.
#include <gmock/gmock.h>

#include "gap/body/moving_robot.hpp"
#include "gap/body/standing_robot.hpp"
#include "gap/identify/body/battery.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/identify/body/floor_text.hpp"

namespace darwinop::gap {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

FloorSelection answerFor(const FloorModel& hidden, std::uint64_t seed = 1) {
  return identifyFloor(standingRobot(hidden, seed), shippedOnFloor(), {}, 0);
}

double openRows(const std::vector<BodyRow>& rows) {
  return static_cast<double>(std::ranges::count_if(rows, &BodyRow::open));
}

TEST(BodyFloor, AStandingRobotReadsGravityAndAFloorThatSlopesTurnsIt) {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  addRecording(given, BodySetup::kLying, 10, false);
  given.logs[0].setup = BodySetup::kFloor, given.logs[0].lies_on.clear();
  const MovingImu imu{given.joints.model};
  FloorModel model = shippedOnFloor();
  const Eigen::RowVector3d level = imu.of(rollOut(given, 0, model.robot), model.imu).accel_m_s2.row(9);
  EXPECT_NEAR(level.norm(), 9.81, 0.02);
  EXPECT_NEAR(level[0], 0, 0.02);  // right
  model.robot.floor.tilt_rad = {0.05, 0};
  const Eigen::RowVector3d left_up = imu.of(rollOut(given, 0, model.robot), model.imu).accel_m_s2.row(9);
  EXPECT_NEAR(left_up[0], -9.81 * 0.05, 0.1);
  given.logs[0].setup = BodySetup::kLying, given.logs[0].lies_on = "front";
  model.robot.floor.tilt_rad = {0, 0};
  const Eigen::RowVector3d face_down = imu.of(rollOut(given, 0, model.robot), model.imu).accel_m_s2.row(9);
  EXPECT_NEAR(face_down[1], -9.81, 0.5);  // forward
}

TEST(BodyFloor, ARobotLikeItsModelHasNoName) {
  const FloorSelection answer = answerFor(shippedOnFloor());
  EXPECT_EQ(openRows(answer.rows), 0);
  EXPECT_THAT(answer.found, IsEmpty());
}

// Other cone of friction, softer contacts, finer steps: not the model's fault.
TEST(BodyFloor, AnotherEngineHasNoName) {
  FloorModel hidden = shippedOnFloor();
  hidden.robot.engine = {.pyramidal_friction = true, .impedance = 2, .step_divisor = 4, .drop_m = 0.0005};
  hidden.robot.floor.contact_time_factor = 1.25;
  EXPECT_THAT(answerFor(hidden).found, IsEmpty());
}

TEST(BodyFloor, AFloorThatSlopesIsNamedWithBothAngles) {
  FloorModel hidden = shippedOnFloor();
  hidden.robot.floor.tilt_rad = {0.03, -0.01};
  const FloorSelection answer = answerFor(hidden);
  ASSERT_THAT(answer.found, SizeIs(1));
  const FoundFloor& found = answer.found.front();
  EXPECT_EQ(found.placed.effect->id, "floor_tilt");
  EXPECT_NEAR(found.placed.values[0], 0.03, 0.003);
  EXPECT_NEAR(found.placed.values[1], -0.01, 0.003);
  EXPECT_EQ(openRows(answer.rows_after), 0);
  EXPECT_EQ(effectJson(found)["at"], "floor");
  EXPECT_THAT(effectJson(found)["params"]["tilt"], SizeIs(2));
}

TEST(BodyFloor, ACentreOfMassOfTheTrunkIsNamedWithItsShift) {
  FloorModel hidden = shippedOnFloor();
  hidden.robot.floor.trunk_com_shift_m = {0, 0, -0.015};
  const FloorSelection answer = answerFor(hidden);
  ASSERT_THAT(answer.found, SizeIs(1));
  EXPECT_EQ(answer.found.front().placed.effect->id, "link_com");
  EXPECT_NEAR(answer.found.front().placed.values[2], -0.015, 0.003);
}

TEST(BodyFloor, AScaleOfTheGyroscopeIsNamedByMotionAlone) {
  FloorModel hidden = shippedOnFloor();
  hidden.imu.gyro.scale = {1, 1.15, 1};  // pitch: the hips lean
  const FloorSelection answer = answerFor(hidden);
  ASSERT_THAT(answer.found, SizeIs(1));
  EXPECT_EQ(answer.found.front().placed.effect->id, "gyro_scale");
  EXPECT_NEAR(answer.found.front().placed.values[1], 1.15, 0.03);
}

/// The board's voltage falls by this resistance times the current of all servos, in steps of 0.1 V.
BodyCase withBattery(double ohm) {
  BodyCase given = movingRobot(shippedRobot());
  const twin::ServoParameters& servo = given.joints.model.servo;
  Rng rng{5};
  for (std::size_t log = 0; log < given.logs.size(); ++log)
    for (std::size_t row = 1; row + 1 < given.logs[log].rows(); ++row) {
      double drawn_a = 0;
      for (std::size_t joint = 0; joint < kJoints; ++joint) {
        const Trajectory& of = given.joint(log, joint);
        const double speed = (of.position_rad[row + 1] - of.position_rad[row - 1]) / 0.032;
        drawn_a += of.load[row] * (of.load[row] * 11.8 - servo.back_emf_vs_rad * speed) / servo.resistance_ohm;
      }
      given.logs[log].board_v[row] = std::round(10 * (11.8 - ohm * drawn_a + 0.03 * rng.normal())) / 10;
    }
  return given;
}

TEST(BodyFloor, TheResistanceOfABatteryIsNamedByTheVoltageOfTheBoard) {
  const std::optional<FoundBattery> found = identifyBattery(withBattery(0.5));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->resistance_ohm, 0.5, 0.05);
  EXPECT_EQ(effectJson(*found)["id"], "battery_resistance");
  EXPECT_FALSE(identifyBattery(withBattery(0)));
  BodyCase low = withBattery(0);  // another battery than the case says
  for (BodyLog& log : low.logs)
    for (double& volt : log.board_v) volt -= 0.4;
  EXPECT_FALSE(identifyBattery(low));
  BodyCase medians = withBattery(0.5);  // a recording's voltage is its median reading
  for (BodyLog& log : medians.logs) {
    std::vector<double> volts = log.board_v;
    std::ranges::nth_element(volts, volts.begin() + std::ssize(volts) / 2);
    log.battery_v = volts[volts.size() / 2];
  }
  const std::optional<FoundBattery> of_medians = identifyBattery(medians);
  ASSERT_TRUE(of_medians);
  EXPECT_NEAR(of_medians->resistance_ohm, 0.5, 0.05);
  BodyCase known = withBattery(0.5);
  known.joints.model.body.battery_resistance_ohm = 0.5;
  EXPECT_FALSE(identifyBattery(known)) << "the model has it";
}

TEST(BodyFloor, AResistanceThatAHeldOutLogContradictsHasNoName) {
  BodyCase given = withBattery(0.5);
  for (BodyLog& log : given.logs)
    if (log.held_out) log.board_v.assign(log.rows(), log.battery_v);
  EXPECT_FALSE(identifyBattery(given));
}

TEST(BodyFloor, WithoutSuchARecordingNothingIsLookedFor) {
  BodyCase given = standingRobot(shippedOnFloor());
  for (BodyLog& log : given.logs) log.held_out = true;
  const FloorSelection answer = identifyFloor(given, shippedOnFloor(), {}, 0);
  EXPECT_THAT(answer.rows, IsEmpty());
  EXPECT_THAT(answer.found, IsEmpty());
}

TEST(BodyFloor, ARecordingOfTheRuntimeIsNotComparedOnTheFloor) {
  BodyCase given = standingRobot(shippedOnFloor());
  ASSERT_TRUE(canSimulateFloor(given));
  for (Trajectory& joint : given.joints.logs) joint.read_s.assign(joint.rows(), 0.002);
  EXPECT_FALSE(canSimulateFloor(given));
}

}  // namespace
}  // namespace darwinop::gap
