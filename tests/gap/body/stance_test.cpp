// Effects of the gyroscope by the kinematics of the feet that stand.
#include <gmock/gmock.h>

#include <filesystem>

#include "gap/body/standing_robot.hpp"
#include "gap/identify/body/stance_selection.hpp"
#include "support/shared_data.hpp"

namespace darwinop::gap {
namespace {

struct StanceAnswer {
  std::string id;
  std::vector<double> values;
};

StanceAnswer stanceAnswer(const BodyCase& given, const FloorModel& about) {
  const MovingImu imu{given.joints.model};
  const std::vector<FloorEffect> effects = floorEffects(given.joints.model);
  const std::optional<FoundFloor> found = StanceSelection{given, imu, about}.best(effects);
  return found ? StanceAnswer{std::string{found->placed.effect->id}, found->placed.values} : StanceAnswer{"none", {}};
}

/// Of a robot on a slippery, soft and tilted floor, which the answer does not know.
StanceAnswer onAnotherFloor(const ImuDeviation& imu) {
  FloorModel hidden = shippedOnFloor();
  hidden.imu = imu;
  hidden.robot.floor.friction_factor = 0.4, hidden.robot.floor.contact_time_factor = 1.5;
  hidden.robot.floor.tilt_rad = {0.02, 0.01};
  return stanceAnswer(standingRobot(hidden), shippedOnFloor());
}

TEST(Stance, AFloorAndItsContactsHaveNoNameOfTheGyroscope) {
  EXPECT_EQ(onAnotherFloor({}).id, "none");
}

TEST(Stance, AScaleIsNamedWhateverTheFloor) {
  ImuDeviation imu;
  imu.gyro.scale = {1, 1.15, 1};  // pitch: the hips lean
  const StanceAnswer answer = onAnotherFloor(imu);
  ASSERT_EQ(answer.id, "gyro_scale");
  EXPECT_EQ(answer.values[0], 1);
  EXPECT_NEAR(answer.values[1], 1.15, 0.03);
}

TEST(Stance, BesideALegThatIsNotExplainedAGyroscopeIsNamedWithoutASimulation) {
  FloorModel hidden = shippedOnFloor();
  hidden.imu.gyro.scale = {1, 1.15, 1};
  const FloorSelection answer = identifyMovingGyro(standingRobot(hidden), shippedOnFloor());
  ASSERT_EQ(answer.found.size(), 1u);
  EXPECT_EQ(answer.found.front().placed.effect->id, "gyro_scale");
  EXPECT_TRUE(answer.rows.empty());
}

TEST(Stance, AFilterADelayALimitAndAReversedAxisAreDistinguished) {
  ImuDeviation slow, late, limited, reversed;
  slow.lowpass_s = 0.03, late.delay_s = 0.04, limited.range_rad_s = 0.5;
  reversed.gyro.map(1, 1) = -1;
  const StanceAnswer of_slow = onAnotherFloor(slow), of_late = onAnotherFloor(late), of_limit = onAnotherFloor(limited);
  EXPECT_EQ(of_slow.id, "gyro_lowpass");
  EXPECT_NEAR(of_slow.values.at(0), 0.03, 0.006);
  EXPECT_EQ(of_late.id, "imu_delay");
  EXPECT_NEAR(of_late.values.at(0), 0.04, 0.006);
  EXPECT_EQ(of_limit.id, "gyro_range");
  EXPECT_NEAR(of_limit.values.at(0), 0.5, 0.05);
  EXPECT_EQ(onAnotherFloor(reversed).id, "gyro_axes");
}

TEST(Stance, WhatTheModelHasAlreadyIsNotFoundAgain) {
  FloorModel slow = shippedOnFloor(), late = slow, scaled = slow;
  slow.imu.lowpass_s = 0.03, late.imu.delay_s = 0.04, scaled.imu.gyro.scale = {1, 1.15, 1};
  BodyCase of_slow = standingRobot(slow), of_late = standingRobot(late), of_scaled = standingRobot(scaled);
  of_slow.joints.model.imu.gyro_lowpass_s = 0.03;
  of_late.joints.model.imu.delay_s = 0.04;
  of_scaled.joints.model.imu.gyro_scale = {1, 1.15, 1};
  for (const BodyCase* const of : {&of_slow, &of_late, &of_scaled})
    EXPECT_EQ(stanceAnswer(*of, shippedOnFloor()).id, "none");
}

TEST(Stance, AScaleThatThisRobotDoesNotHaveIsRefuted) {
  const BodyCase given = standingRobot(shippedOnFloor());
  const MovingImu imu{given.joints.model};
  const StanceSelection stance{given, imu, shippedOnFloor()};
  ImuDeviation scaled;
  scaled.gyro.scale = {1, 1.15, 1};
  EXPECT_TRUE(stance.refutes(scaled));
}

/// Shown by a clamped trunk too, which may be the model's own bias.
BodyCase robotWithBias(const FloorModel& hidden) {
  constexpr double kBias = 0.2;  // rad/s
  BodyCase out = standingRobot(hidden);
  addRecording(out, BodySetup::kClamped, 60, false);
  BodyLog& clamped = out.logs.back();
  clamped.up = Axes{0, 1, 0};
  Rng rng{7};
  for (std::vector<double>& axis : clamped.gyro_rad_s)
    for (std::size_t row = 0; row < clamped.rows(); ++row) axis.push_back(0.03 * rng.normal());
  for (BodyLog& log : out.logs)
    for (double& value : log.gyro_rad_s[1]) value += kBias;
  out.joints.model.imu.gyro_bias_rad_s[1] = kBias;
  return out;
}

TEST(Stance, ABiasThatTheModelHasIsNotAddedAgain) {
  FloorModel scaled = shippedOnFloor();
  scaled.imu.gyro.scale = {1, 1.15, 1};
  EXPECT_EQ(stanceAnswer(robotWithBias(shippedOnFloor()), shippedOnFloor()).id, "none");
  const StanceAnswer answer = stanceAnswer(robotWithBias(scaled), shippedOnFloor());
  ASSERT_EQ(answer.id, "gyro_scale");
  EXPECT_NEAR(answer.values[1], 1.15, 0.03);
}

TEST(Stance, NoFootStandsWhileTheRobotTipsOver) {
  BodyCase given = standingRobot(shippedOnFloor());
  const MovingImu imu{given.joints.model};
  const auto rows = [&] { return StanceGyro{given, imu, {0}, {0.02, 0.02, 0.02}}.rows(); };
  const std::size_t all = rows();
  ASSERT_EQ(all, given.logs[0].rows());
  given.logs[0].fell_at_s = given.logs[0].time_s.back();
  EXPECT_NEAR(static_cast<double>(all - rows()), 0.5 / 0.016, 1);
}

TEST(Stance, AServoThatMissesAnAnswerIsWhereItsNeighboursInTimeShowIt) {
  BodyCase given = standingRobot(shippedOnFloor());
  constexpr std::size_t kMissing = 60;
  const Eigen::MatrixX3d all = stanceRates(given, 0)[0].forward;
  given.joints.logs[index(Joint::kLegLowerR)].position_rad[kMissing] = std::nan("");
  const StanceRates without = stanceRates(given, 0)[0];
  EXPECT_TRUE(without.known[kMissing]);
  EXPECT_LT((without.forward - all).cwiseAbs().maxCoeff(), 0.02) << "a knee at 0 would turn the foot by its angle";
}

// Robots of another simulator, in which the gyroscope has at most a bias or a turned board.
TEST(Stance, ExampleCasesWithoutSuchAnEffectHaveNoName) {
  if (!std::filesystem::exists(sharedData("body-gap-cases"))) GTEST_SKIP() << "no example cases";
  for (const auto& folder : std::filesystem::directory_iterator{sharedData("body-gap-cases") / "cases"}) {
    const BodyCase given = readBodyCase(folder.path().string());
    const FloorModel about{.robot = {.robot = {bodyBaselineOf(given), {}}, .floor = {}}};
    EXPECT_EQ(stanceAnswer(given, about).id, "none") << folder;
  }
}

}  // namespace
}  // namespace darwinop::gap
