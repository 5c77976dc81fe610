// Controllers that die while they wait for a takeover, and what one sends after it was given up or has ended.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

void losePower(Rig& rig) {
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.runFor(1);
}

void silenceServos(Rig& rig, bool silent) {
  for (FakeServo& servo : rig.robot.servo) servo.answers = !silent;
}

/// A session comes to a limp robot that cannot be taken over.
void waitForTakeover(Rig& rig) {
  ASSERT_EQ(rig.state(), State::kLimp);
  rig.newSession();
  rig.run(3);
  ASSERT_EQ(rig.state(), State::kTakingOver);
}

void expectItStaysLimp(Rig& rig, double seconds) {
  const int cycles = static_cast<int>(seconds * 1e9 / static_cast<double>(rig.robot.period_ns));
  for (int i = 0; i < cycles; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kLimp) << "cycle " << i;
    ASSERT_TRUE(rig.safe->driven().none()) << "cycle " << i;
  }
}

TEST(GivenUp, AControllerThatDiesWhileItWaitsForPowerRaisesNoRobotWhenItReturns) {
  Rig rig;
  rig.runFor(1);
  losePower(rig);
  waitForTakeover(rig);
  rig.steps = false;
  rig.runFor(rig.config.gone_s + 1);
  ASSERT_TRUE(rig.active(Fault::kControllerGone));
  rig.robot.power_obeys = true;
  expectItStaysLimp(rig, 5);
}

TEST(GivenUp, AControllerThatDiesWhileItWaitsForServosRaisesNoRobotWhenTheyAnswer) {
  Rig rig;
  rig.runFor(1);
  silenceServos(rig, true);
  rig.runFor(1);
  waitForTakeover(rig);
  rig.steps = false;
  rig.runFor(rig.config.take_over_s + rig.config.gone_s + 1);
  silenceServos(rig, false);
  expectItStaysLimp(rig, 5);
}

TEST(GivenUp, PowerThatReturnsSoonerDoesNotMoveTheRobotOfADeadController) {
  Rig rig;
  rig.runFor(1);
  losePower(rig);
  waitForTakeover(rig);
  rig.steps = false;
  rig.runFor(rig.config.gone_s / 2);
  const auto before = rig.robot.servo;
  rig.robot.power_obeys = true;
  ASSERT_TRUE(rig.reach(State::kHolding));
  rig.runFor(1);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_NEAR(rig.robot.servo[i].position, before[i].position, 0.03) << kJointTable[i].name;
  ASSERT_TRUE(rig.reach(State::kKneeling)) << "given up";
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(GivenUp, ALivingControllerWaitsForPowerAsLongAsItLikes) {
  Rig rig;
  rig.runFor(1);
  losePower(rig);
  waitForTakeover(rig);
  rig.runFor(3 * rig.config.gone_s);
  EXPECT_EQ(rig.state(), State::kTakingOver);
  rig.robot.power_obeys = true;
  EXPECT_TRUE(rig.reach(State::kDriven));
}

/// Stands on bent knees with a limp head, and kneels because of its controller.
struct Kneeling : testing::TestWithParam<bool> {
  Rig rig;

  Kneeling() {
    rig.start();
    rig.joint(Joint::kLegLowerR).setGoal(Rad{1.8});
    rig.joint(Joint::kHead).setTorque(false);
    rig.runFor(2);
    rig.steps = hasEnded();
    rig.commands.end_of_session = hasEnded();
    EXPECT_TRUE(rig.reach(State::kKneeling));
    rig.run(3);
  }
  [[nodiscard]] static bool hasEnded() { return GetParam(); }

  /// The same session goes on sending.
  void resume() {
    rig.steps = true;
    rig.commands.end_of_session = false;
  }
};
INSTANTIATE_TEST_SUITE_P(GivenUpOrEnded, Kneeling, ::testing::Bool());

TEST_P(Kneeling, IgnoresTorqueSwitchesOfItsSession) {
  resume();
  rig.joint(Joint::kLegLowerR).setTorque(false);
  rig.joint(Joint::kHead).setTorque(true);
  while (rig.state() == State::kKneeling) {
    ASSERT_TRUE(rig.driven(Joint::kLegLowerR));
    ASSERT_FALSE(rig.driven(Joint::kHead));
    rig.cycle();
    ASSERT_TRUE(rig.state() == State::kLimp || rig.safe->torqueOff().none());
  }
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST_P(Kneeling, IgnoresAStopOfItsSession) {
  resume();
  rig.commands.hold = true;
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST_P(Kneeling, IsInterruptedByANewSession) {
  resume();
  rig.newSession();
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(GivenUp, TheImageThatEndsASessionStillSwitchesTorque) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kHead).setTorque(false);
  rig.commands.end_of_session = true;
  rig.cycle();
  EXPECT_TRUE(rig.safe->torqueOff()[index(Joint::kHead)]);
}

TEST(GivenUp, AControllerMayBeSilentDuringTakeoverAndStart) {
  Config config;
  config.gentle_speed = kLeastGentleSpeed;
  Rig rig{config};
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kTakingOver));
  rig.steps = false;
  const int cycles = rig.runUntil([&] { return rig.state() == State::kDriven; });
  EXPECT_GT(0.016 * cycles, 3) << "s";
  EXPECT_FALSE(rig.active(Fault::kControllerStalled));
}

}  // namespace
}  // namespace darwinop::safety
