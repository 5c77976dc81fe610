// The robot comes back: after a lost link, a board reset, a servo that was away.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

void look(Rig& rig) {
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.runFor(1);
}

/// Runs until the neck has reached `goal`, and returns its greatest speed on the way.
double fastestUntil(Rig& rig, double goal) {
  double fastest = 0;
  for (int i = 0; i < 1000 && std::abs(rig.robot[Joint::kNeck].position - goal) > 0.005; ++i) {
    const double before = rig.robot[Joint::kNeck].position;
    rig.cycle();
    fastest = std::max(fastest, std::abs(rig.robot[Joint::kNeck].position - before) / 0.016);
  }
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, goal, 0.005);
  return fastest;
}

TEST(Recovery, NothingIsSentFromSixCyclesOfSilenceOn) {
  Rig rig;
  look(rig);
  rig.robot.board_answers = false;
  rig.run(6);
  EXPECT_EQ(rig.state(), State::kDriven) << "five missed replies are not a reason";
  rig.run(1);
  EXPECT_EQ(rig.state(), State::kOffline);
  EXPECT_EQ(rig.safe->write(), Write::kNothing);
  EXPECT_TRUE(rig.active(Fault::kBusSilent));
  EXPECT_EQ(rig.report().reaction, Reaction::kStopSending);
  EXPECT_FALSE(rig.report().controller_must_end);
}

TEST(Recovery, AfterALostLinkJointsRestartWhereTheyAreAndCatchUpGently) {
  Rig rig;
  look(rig);
  rig.robot.board_answers = false;
  rig.runFor(2);
  rig.robot[Joint::kNeck].position = rig.robot[Joint::kNeck].goal = -0.6;  // somebody moved it
  rig.robot.board_answers = true;
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kNeck); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kNeck), -0.6, kRadPerTick);
  EXPECT_LE(fastestUntil(rig, 1.0), 1.194 + 1e-6);
  EXPECT_EQ(rig.state(), State::kDriven) << "no second move to the start pose";
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Recovery, ALinkLostInTheStartMoveEndsInTheStartPose) {
  Rig rig;
  rig.robot[Joint::kNeck].position = 1.5;
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kStarting));
  rig.run(20);
  rig.robot.board_answers = false;
  rig.run(20);
  rig.robot.board_answers = true;
  ASSERT_TRUE(rig.reach(State::kStarting));
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, 0.003, 0.005);
}

TEST(Recovery, AServoThatTheBusHasGivenUpGetsNoGoalsUntilItsPositionIsConfirmed) {
  Rig rig;
  look(rig);
  rig.robot[Joint::kNeck].answers = false;
  rig.robot.given_up.set(index(Joint::kNeck));
  rig.run(2);
  EXPECT_FALSE(rig.driven(Joint::kNeck)) << "it may have restarted, and then it knows no speed limit";
  EXPECT_TRUE(rig.driven(Joint::kHead));
  rig.robot[Joint::kNeck].answers = true;
  rig.robot[Joint::kNeck].torque = false;   // it has restarted
  rig.robot[Joint::kNeck].position = -0.4;  // and swung
  rig.robot.given_up.reset();
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kNeck); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kNeck), -0.4, kRadPerTick);
  EXPECT_LE(rig.safe->goal(Joint::kNeck).speed_limit.value, rig.config.gentle_speed);
}

TEST(Recovery, AControllerThatDiedWhileTheLinkWasLostDoesNotDriveAgain) {
  Rig rig;
  look(rig);
  rig.robot.board_answers = false;
  rig.steps = false;
  rig.runFor(12);
  rig.robot.board_answers = true;
  ASSERT_TRUE(rig.reach(State::kKneeling)) << "torque was left on: sit down before releasing torque";
  ASSERT_TRUE(rig.reach(State::kLimp));
  EXPECT_FALSE(rig.robot[Joint::kNeck].torque);
}

TEST(Recovery, AfterABoardResetPowerComesOnAndTheRobotStaysLimpUntilAPersonActs) {
  Rig rig;
  look(rig);
  rig.robot.servo_power = false;
  rig.robot.power_obeys = false;
  rig.run(5);
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_TRUE(rig.active(Fault::kBoardReset));
  EXPECT_TRUE(rig.report().controller_must_end);
  EXPECT_TRUE(rig.safe->driven().none()) << "a goal that waits for power would be a jump";
  EXPECT_TRUE(rig.safe->powerOn());
  rig.runFor(1);
  rig.robot[Joint::kNeck].position = -0.4;  // it sank
  rig.robot.power_obeys = true;
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_TRUE(rig.safe->driven().none());
    ASSERT_TRUE(rig.safe->torqueOn().none());
  }
  EXPECT_TRUE(rig.robot.servo_power) << "what the servos say can be read";
  EXPECT_FALSE(rig.active(Fault::kServoPowerOff));
  ++rig.commands.operator_resets;
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kNeck); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kNeck), -0.4, kRadPerTick);
  EXPECT_TRUE(rig.reach(State::kStarting)) << "a start like any other";
  EXPECT_TRUE(rig.reach(State::kDriven));
  EXPECT_FALSE(rig.active(Fault::kBoardReset));
}

TEST(Recovery, ARobotThatIsSwitchedOnHasLostNoPower) {
  Rig rig;
  rig.robot.servo_power = false;
  rig.robot.power_obeys = false;
  rig.newSession();
  for (int i = 0; i < 400 && rig.state() != State::kDriven; ++i) {
    if (i == 4) rig.robot.power_obeys = true;
    rig.cycle();
    EXPECT_FALSE(rig.active(Fault::kBoardReset)) << "cycle " << i;
  }
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST(Recovery, AfterABoardResetInTheStartMoveThePersonsResetLeadsToTheStartPose) {
  Rig rig;
  rig.robot[Joint::kNeck].position = 1.5;
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kStarting));
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.run(20);
  EXPECT_EQ(rig.state(), State::kLimp);
  rig.robot.power_obeys = true;
  ++rig.commands.operator_resets;
  ASSERT_TRUE(rig.reach(State::kStarting));
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, 0.003, 0.005);
}

TEST(Recovery, ARobotWithoutTorqueIsNotRaisedInOrderToKneel) {
  Rig rig;
  look(rig);
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.run(5);
  rig.robot.board_answers = false;
  rig.steps = false;
  rig.runFor(12);
  rig.robot.board_answers = rig.robot.servo_power = true;
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_TRUE(rig.safe->driven().none());
  }
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST(Recovery, AJointThatWasNeverCommandedReturnsToTheStartPose) {
  Rig rig;
  rig.start();
  rig.robot[Joint::kHead].answers = false;
  rig.runFor(1);
  rig.robot[Joint::kHead].position = rig.robot[Joint::kHead].goal = 0.8;
  rig.robot[Joint::kHead].answers = true;
  rig.runFor(1.5);
  EXPECT_NEAR(rig.robot[Joint::kHead].position, radFromTicks(2173).value, 0.005);
}

TEST(Recovery, OneCorruptedPowerBitIsNotAReset) {
  Rig rig;
  look(rig);
  rig.robot.seen.board.servo_power = false;
  rig.cycle();
  EXPECT_FALSE(rig.safe->powerOn()) << "the next answer has to confirm it";
  EXPECT_TRUE(rig.safe->driven().all());
  rig.run(3);
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Recovery, AJointAwayForLongRestartsWhereItIs) {
  Rig rig;
  look(rig);
  rig.robot[Joint::kNeck].answers = false;
  rig.cycle();
  for (std::uint32_t i = 0; i < kAnswerPatience; ++i) {
    rig.cycle();
    EXPECT_TRUE(rig.driven(Joint::kNeck));
    EXPECT_TRUE(rig.skipped(Joint::kNeck)) << "it may have restarted: a goal would switch its torque on";
  }
  rig.cycle();
  EXPECT_FALSE(rig.driven(Joint::kNeck));
  rig.robot[Joint::kNeck].torque = false;
  rig.robot[Joint::kNeck].position = -0.2;
  rig.robot[Joint::kNeck].answers = true;
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kNeck); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kNeck), -0.2, kRadPerTick);
  EXPECT_LE(fastestUntil(rig, 1.0), 1.194 + 1e-6);
}

TEST(Recovery, AServoThatMissedAnAnswerGetsNoGoalUntilAPollShowsThatItHasNotRestarted) {
  Rig rig;
  look(rig);
  rig.joint(Joint::kNeck).setGoal(Rad{0.5});
  rig.robot[Joint::kNeck].answers = false;
  rig.cycle();
  rig.robot[Joint::kNeck].answers = true;
  rig.cycle();
  EXPECT_TRUE(rig.skipped(Joint::kNeck));
  rig.cycle();
  EXPECT_FALSE(rig.skipped(Joint::kNeck)) << "polled";
  EXPECT_LT(rig.goal(Joint::kNeck), 1.0) << "and goes on where it was, without a takeover";
}

TEST(Recovery, AServoFoundRestartedByAPollIsTakenOverWhereItIs) {
  for (const bool switched_on : {false, true}) {
    Rig rig;
    look(rig);
    rig.robot[Joint::kNeck].answers = false;
    rig.cycle();
    rig.robot[Joint::kNeck].answers = true;
    rig.robot[Joint::kNeck].torque = switched_on;  // by a goal that was on its way
    rig.robot[Joint::kNeck].restarted = true;
    rig.robot[Joint::kNeck].position = 0.6;
    rig.robot[Joint::kNeck].follows = false;
    rig.run(2);
    EXPECT_FALSE(rig.driven(Joint::kNeck));
    ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kNeck); }), 0);
    EXPECT_NEAR(rig.goal(Joint::kNeck), 0.6, kRadPerTick);
    EXPECT_TRUE(rig.report().active.none());
  }
}

TEST(Recovery, AJointThatReturnsWithOneCorruptedReadingIsNotSentThere) {
  Rig rig;
  look(rig);
  rig.robot[Joint::kNeck].answers = false;
  rig.run(40);
  rig.robot[Joint::kNeck].answers = true;
  rig.robot[Joint::kNeck].corruption = -1.5;
  for (int i = 0; i < 10; ++i) {
    rig.cycle();
    if (rig.driven(Joint::kNeck)) {
      ASSERT_NEAR(rig.goal(Joint::kNeck), 1.0, 0.03);
    }
  }
}

}  // namespace
}  // namespace darwinop::safety
