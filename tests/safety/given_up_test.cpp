// Controllers that die while they wait for a takeover.
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
