// Gait manager on a simulated robot.
#include <gmock/gmock.h>

#include <cmath>
#include <webots/Motor.hpp>

#include "gait_rig.hpp"
#include "managers/gait/golden.hpp"
#include "managers/messages.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPGaitManager;
using testing::HasSubstr;

std::vector<std::array<int, kWalking>> goldenOf(const std::string& scenario) {
  std::vector<std::array<int, kWalking>> calls;
  for (const gait::GoldenCall& call : gait::goldenCalls())
    if (call.scenario == scenario) calls.push_back(call.tick);
  return calls;
}

TEST_F(GaitManager, SendsTheGoalsOfTheReference) {
  standing().setXAmplitude(1);
  manager().start();
  const auto golden = goldenOf("G2_forward");
  for (std::size_t call = 1; call < golden.size(); call += 2) {
    steps(1);
    ASSERT_EQ(goals(), golden[call]) << call;
  }
  EXPECT_EQ(fake.last().joint[index(Joint::kNeck)].set, 0);
  EXPECT_EQ(fake.last().joint[index(Joint::kHead)].set, 0);
}

TEST_F(GaitManager, CirclesAroundAPointInFrontAsTheReferenceDoesWithTheMoveAimOn) {
  standing().setXAmplitude(0.5);
  manager().setYAmplitude(-0.4);
  manager().setAAmplitude(-0.3);
  manager().setMoveAimOn(true);
  manager().start();
  const auto golden = goldenOf("G5_mix_aim");
  ASSERT_FALSE(golden.empty());
  for (std::size_t call = 1; call < golden.size(); call += 2) {
    steps(1);
    ASSERT_EQ(goals(), golden[call]) << call;
  }
}

TEST_F(GaitManager, CarriesTheRemainderOfAStepOver) {
  standing().step(12);  // at rest: the remainder is discarded
  manager().start();
  const auto golden = goldenOf("G1_inplace");
  for (std::size_t step = 1; step <= 80; ++step) {
    steps(1, 20);
    ASSERT_EQ(goals(), golden[step * 20 / 8 - 1]) << step;
  }
}

TEST_F(GaitManager, ClampsAmplitudesAndIgnoresNaN) {
  testing::internal::CaptureStderr();
  standing().setXAmplitude(1.7);
  manager().setXAmplitude(NAN);
  manager().setYAmplitude(NAN);
  manager().setAAmplitude(NAN);
  manager().start();
  steps(112);
  EXPECT_EQ(goals(), goldenOf("G2_forward")[223]);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("setXAmplitude(NaN) is ignored"));
  EXPECT_THAT(said, HasSubstr("setAAmplitude(NaN) is ignored"));
}

TEST_F(GaitManager, SetsPGainsAndFullSpeed) {
  write("[Walking Config]\np_gain = 40\n");
  webots::Motor& knee = *robot().getMotor("LegLowerR");
  knee.setVelocity(0.5);
  knee.setAcceleration(3);
  standing().start();
  steps(1);
  const auto& joints = fake.last().joint;
  EXPECT_EQ(joints[index(Joint::kLegLowerR)].p_gain, 5);
  EXPECT_EQ(joints[index(Joint::kFootL)].p_gain, 5);
  EXPECT_EQ(joints[index(Joint::kArmUpperL)].p_gain, 1);
  for (std::size_t i = 0; i < kWalking; ++i) EXPECT_GT(joints[i].speed_limit.value, 12) << kJointTable[i].name;
  manager().stop();
  EXPECT_EQ(knee.getVelocity(), 0.5);
  EXPECT_EQ(knee.getAcceleration(), 3);
  EXPECT_EQ(fake.last().joint[index(Joint::kArmUpperL)].p_gain, 4);
}

TEST_F(GaitManager, BalanceUsesTheGyroscope) {
  standing().setBalanceEnable(true);
  steps(100);  // calibrates, one sample per cycle
  expectUntouched();
  manager().start();
  steps(3);
  const auto golden = goldenOf("G1_inplace");
  EXPECT_EQ(goals(), golden[5]);
  fake.image.board.gyro[1] = RadPerSec{-1.0};  // falls forwards: 16 counts
  steps(1);
  EXPECT_EQ(goals(), golden[7]) << "read in the next step";
  steps(1);
  const auto falling = goals();
  EXPECT_NEAR(falling[index(Joint::kLegLowerR)] - golden[9][index(Joint::kLegLowerR)], 19, 1);
  EXPECT_NEAR(falling[index(Joint::kAnkleR)] - golden[9][index(Joint::kAnkleR)], -57, 2);
  EXPECT_NEAR(falling[index(Joint::kAnkleL)] - golden[9][index(Joint::kAnkleL)], 57, 2);
}

TEST_F(GaitManager, StandsUntilTheGyroscopeIsCalibrated) {
  standing().setBalanceEnable(true);
  fake.image.board.gyro[0] = RadPerSec{0.3};  // zero offset
  robot().step(16);
  manager().start();
  for (int i = 0; i < 100; ++i) {
    steps(1);
    ASSERT_EQ(goals(), gait::kStanding.tick) << i;
  }
  steps(3);
  EXPECT_EQ(goals(), goldenOf("G1_inplace")[6]);
}

TEST_F(GaitManager, AGyroscopeReadingIsUsedOnce) {
  standing().setBalanceEnable(true);
  manager().start();
  for (int cycle = 0; cycle < 98; ++cycle) {
    manager().step(8);
    manager().step(8);
    robot().step(16);
    ASSERT_EQ(goals(), gait::kStanding.tick) << cycle;
  }
  fake.image.board.motion.age = 1;  // not read in the next cycle
  steps(1);
  fake.image.board.motion.age = 0;
  steps(2);
  EXPECT_EQ(goals(), gait::kStanding.tick) << "the 100th sample has just been used";
  steps(3);
  EXPECT_NE(goals(), gait::kStanding.tick);
}

TEST_F(GaitManager, ARobotWithoutAGyroscopeWalksAtOnceWithoutBalance) {
  fake.image.board = {};
  fake.image.board.absent = true;
  testing::internal::CaptureStderr();
  standing().setBalanceEnable(true);
  manager().start();
  steps(2 + 1);
  EXPECT_NE(goals(), gait::kStanding.tick) << "nothing to calibrate";
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kNoGyroscope));
}

TEST_F(GaitManager, AMovedRobotWalksWithoutBalance) {
  standing().setBalanceEnable(true);
  fake.on_cycle = [this](std::uint64_t cycle) { fake.image.board.gyro[0] = RadPerSec{cycle % 2 == 0 ? 1.0 : -1.0}; };
  testing::internal::CaptureStderr();
  manager().start();
  steps(300 + 1 + 20);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(managers::messages::kWalksWithoutBalance));
  EXPECT_EQ(goals(), goldenOf("G1_inplace")[42]);
}

TEST_F(GaitManager, BalanceThatIsSwitchedOnInAWalkThatBeganWithoutItSaysThatItIsOff) {
  standing().start();
  steps(10);
  manager().setBalanceEnable(true);
  testing::internal::CaptureStderr();
  steps(2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kWalksWithoutBalance));
}

TEST_F(GaitManager, AnUnknownGyroscopeGivesNoNaN) {
  standing().setBalanceEnable(true);
  steps(100);
  manager().start();
  fake.image.board.motion.age = 10;
  steps(20);
  EXPECT_EQ(goals(), goldenOf("G1_inplace")[39]);
}

TEST_F(GaitManager, StopReturnsInTheStanceAndReleasesTheMotors) {
  standing().setXAmplitude(1);
  manager().start();
  steps(60);
  const Nanos before = fake.now;
  manager().stop();
  EXPECT_LE(fake.now - before, std::chrono::milliseconds{920});
  EXPECT_EQ(goals(), gait::kStanding.tick);
  robot().getMotor("ShoulderR")->setPosition(0.1);
  steps(20);
  EXPECT_EQ(goals()[0], ticksFromRad(Rad{0.1}));
  manager().stop();  // no effect
}

TEST_F(GaitManager, CallsDuringAStopAreIgnored) {
  standing().setXAmplitude(1);
  manager().start();
  steps(60);
  gait::Engine engine{gait::shipped()};
  engine.start();
  for (int call = 0; call < 120; ++call) engine.next({1, 0, 0, false}, {NAN, NAN});
  engine.stop();
  int calls = 0;
  for (; engine.running(); ++calls) engine.next({}, {NAN, NAN});
  // Like a controller whose overridden Robot::step() also calls the gait manager.
  fake.on_cycle = [this](std::uint64_t) {
    manager().step(16);
    manager().start();
    manager().stop();
  };
  const Nanos before = fake.now;
  manager().stop();
  EXPECT_EQ((fake.now - before) / std::chrono::milliseconds{16}, (calls + 1) / 2);
  fake.on_cycle = {};
}

TEST_F(GaitManager, APageThatStartsDuringAStopTakesTheJoints) {
  standing().start();
  steps(60);
  int page = 0;
  fake.on_cycle = [&page](std::uint64_t) { currentRobot()->joints_taken_by = &page; };
  const Nanos before = fake.now;
  manager().stop();
  EXPECT_EQ(fake.now - before, std::chrono::milliseconds{16});
  EXPECT_EQ(currentRobot()->joints_taken_by, &page);
  fake.on_cycle = {};
}

TEST_F(GaitManager, StopEndsWithTheController) {
  standing().setXAmplitude(1);
  manager().start();
  steps(60);
  fake.gone = true;
  testing::internal::CaptureStderr();
  manager().stop();
  EXPECT_EQ(robot().step(16), -1);
  const double stance = radFromTicks(gait::kStanding[Joint::kShoulderR]).value;
  EXPECT_GT(std::abs(robot().getMotor("ShoulderR")->getTargetPosition() - stance), 0.05);  // the walk did not continue
  testing::internal::GetCapturedStderr();
}

TEST_F(GaitManager, MovesSmoothlyToItsStance) {
  manager().setBalanceEnable(false);
  manager().start();
  steps(1);
  std::array<int, kWalking> last{};
  for (std::size_t i = 0; i < kWalking; ++i) last[i] = kJointTable[i].start;
  int taken = 1;
  for (; goals() != gait::kStanding.tick && taken < 1000; ++taken) {
    for (std::size_t i = 0; i < kWalking; ++i) ASSERT_LE(std::abs(goals()[i] - last[i]), 9) << i;
    last = goals();
    steps(1);
  }
  EXPECT_NEAR(taken * 16, 2675, 40);
}

TEST_F(GaitManager, AKneeBelowItsGoalKeepsItsGoal) {
  JointSensors& knee = fake.image.joint[index(Joint::kLegLowerR)];
  const int goal = ticksFromRad(knee.commanded);
  knee.position.value -= 0.15;
  manager().start();
  steps(1);
  EXPECT_NEAR(goals()[index(Joint::kLegLowerR)], goal, 9);
}

TEST_F(GaitManager, ShortStepsWarnOnce) {
  testing::internal::CaptureStderr();
  standing().start();
  for (int i = 0; i < 10; ++i) manager().step(4);
  manager().step(-5);
  robot().step(16);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("GaitManager: step(4) has no effect"));
  EXPECT_EQ(goals()[0], -1);
}

}  // namespace
}  // namespace darwinop::webots_api
