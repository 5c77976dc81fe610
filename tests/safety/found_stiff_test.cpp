// A robot whose servos hold their joints although nobody drives it, and what "limp" means.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

void makeStiff(Rig& rig) {
  for (FakeServo& servo : rig.robot.servo) servo.torque = true;
}

TEST(FoundStiff, ARobotThatSomebodyElseLeftStiffIsNeverCalledLimp) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    Rig rig;
    rig.robot.servo[i].torque = true;
    for (int cycle = 0; cycle < 100; ++cycle) {
      rig.cycle();
      ASSERT_NE(rig.state(), State::kLimp) << i;
    }
    EXPECT_EQ(rig.state(), State::kFoundStiff);
    EXPECT_TRUE(rig.robot.servo[i].torque) << "it is left as it is";
  }
}

TEST(FoundStiff, ALimpRobotIsCalledSoWithinTwoPollRounds) {
  Rig rig;
  EXPECT_TRUE(rig.reach(State::kLimp));
  EXPECT_LE(rig.robot.seen.cycle, 50U);
}

TEST(FoundStiff, AServoThatNeverAnswersDoesNotKeepARobotFromBeingCalledLimp) {
  Rig rig;
  rig.robot[Joint::kHead].answers = false;
  rig.runFor(1.5);
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST(FoundStiff, AServoThatWasLimpAndIsFoundStiffLaterIsNoticed) {
  Rig rig;
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.robot[Joint::kHead].torque = true;
  rig.run(kJoints + 2);
  EXPECT_EQ(rig.state(), State::kFoundStiff);
  rig.robot[Joint::kHead].torque = false;
  rig.run(kJoints + 2);
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST(FoundStiff, ItIsNotCalledLimpBeforeEveryServoHasBeenPolled) {
  Rig rig;
  FakeServo &first = rig.robot.servo[0], &later = rig.robot.servo[15];
  first.torque = later.torque = true;
  later.polled = false;
  ASSERT_TRUE(rig.reach(State::kFoundStiff));
  first.torque = false;
  rig.run(kJoints + 3);  // the first is seen limp
  EXPECT_EQ(rig.state(), State::kFoundStiff);
  later.polled = true;
  for (int i = 0; i < 30; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kFoundStiff) << "cycle " << i;
  }
}

TEST(FoundStiff, AMissedAnswerDoesNotReleaseAServoThatAnotherProgramLeftWithoutASpeedLimit) {
  Rig rig;
  makeStiff(rig);
  for (FakeServo& servo : rig.robot.servo) servo.restarted = true;  // its moving speed register is 0
  rig.runFor(1);
  rig.robot[Joint::kLegLowerL].answers = false;
  rig.cycle();
  rig.robot[Joint::kLegLowerL].answers = true;
  rig.runFor(1);
  EXPECT_TRUE(rig.robot[Joint::kLegLowerL].torque);
  EXPECT_EQ(rig.state(), State::kFoundStiff);
}

TEST(FoundStiff, AServoThatStaysStiffIsNotCalledLimpAndOnlyItGetsTheOrderAgain) {
  Rig rig;
  rig.start();
  rig.robot[Joint::kHead].receives = false;
  rig.commands.end_of_session = true;
  ASSERT_TRUE(rig.reach(State::kLimp));
  ASSERT_TRUE(rig.reach(State::kFoundStiff));
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kFoundStiff);
    ASSERT_TRUE(rig.safe->torqueOn().none());
    ASSERT_TRUE(rig.safe->driven().none()) << "the others are limp and stay so";
  }
  rig.robot[Joint::kHead].receives = true;
  ASSERT_TRUE(rig.reach(State::kLimp));
  EXPECT_FALSE(rig.robot[Joint::kHead].torque);
}

TEST(FoundStiff, WhenTheLoopClosesItKneelsAndReleasesTorque) {
  Rig rig;
  makeStiff(rig);
  rig.runFor(1);
  rig.commands.end_of_session = true;  // of nobody: session 0
  ASSERT_TRUE(rig.reach(State::kKneeling));
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.runFor(1);
  EXPECT_EQ(rig.state(), State::kLimp);
  for (const FakeServo& servo : rig.robot.servo) EXPECT_FALSE(servo.torque);
}

TEST(FoundStiff, WhenTheLoopClosesALimpRobotStaysLimp) {
  Rig rig;
  rig.runFor(1);
  rig.commands.end_of_session = true;
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.safe->write(), Write::kNothing);
  }
}

TEST(FoundStiff, OnExitHoldLeavesItStiff) {
  Config config;
  config.on_exit = OnExit::kHold;
  Rig rig{config};
  makeStiff(rig);
  rig.commands.end_of_session = true;
  rig.runFor(3);
  EXPECT_EQ(rig.state(), State::kFoundStiff);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
}

TEST(FoundStiff, ASessionTakesOverGentlyFromWhereItStands) {
  Rig rig;
  makeStiff(rig);
  rig.runFor(1);
  rig.newSession();
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kTakingOver);
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(FoundStiff, AnEmptyBatteryMakesItKneel) {
  Rig rig;
  makeStiff(rig);
  rig.runFor(1);
  rig.robot.volt = 9.5;
  ASSERT_TRUE(rig.reach(State::kKneeling));
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(FoundStiff, LossOfPowerMakesItLimpAndWaitsForAPerson) {
  Rig rig;
  makeStiff(rig);
  rig.runFor(1);
  rig.robot.servo_power = false;
  rig.runFor(2);
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_TRUE(rig.active(Fault::kBoardReset));
}

}  // namespace
}  // namespace darwinop::safety
