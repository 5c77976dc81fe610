// How the robot releases torque: end of a session, a controller that is gone, the button.
#include <gtest/gtest.h>

#include "safety/rig.hpp"
#include "safety/session_settings.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::safety {
namespace {

void stand(Rig& rig) {
  rig.start();
  rig.joint(Joint::kLegLowerR).setGoal(Rad{0.3});
  rig.joint(Joint::kLegLowerL).setGoal(Rad{-0.3});
  rig.runFor(1);
}

Config exitBy(OnExit how) {
  Config config;
  config.on_exit = how;
  return config;
}

void expectLimp(const Rig& rig) {
  EXPECT_EQ(rig.state(), State::kLimp);
  for (const FakeServo& servo : rig.robot.servo) EXPECT_FALSE(servo.torque);
}

TEST(Kneel, TheEndOfASessionMakesTheRobotSitDownSlowlyAndReleaseTorque) {
  Rig rig{exitBy(OnExit::kKneel)};
  stand(rig);
  rig.commands.end_of_session = true;
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kKneeling);
  double last = rig.robot[Joint::kLegLowerR].position;
  while (rig.state() == State::kKneeling) {
    rig.cycle();
    ASSERT_LE(std::abs(rig.robot[Joint::kLegLowerR].position - last), 1.194 * 0.016 + 1e-9);
    last = rig.robot[Joint::kLegLowerR].position;
  }
  EXPECT_NEAR(last, startPose(rig.config)[index(Joint::kLegLowerR)].value, 0.01);
  expectLimp(rig);
  rig.runFor(5);
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_EQ(rig.safe->write(), Write::kNothing);
  EXPECT_TRUE(rig.report().active.none()) << "a normal end is not a fault";
}

TEST(Kneel, AllJointsArriveTogetherSoThatTheFeetStayFlatOnTheWayDown) {
  Rig rig{exitBy(OnExit::kKneel)};
  rig.start();
  const std::array leg{Joint::kLegUpperR, Joint::kLegLowerR, Joint::kAnkleR};
  for (const Joint joint : leg) rig.joint(joint).setGoal(Rad{0});  // straight
  rig.runFor(3);
  rig.commands.end_of_session = true;
  std::array<double, 3> begin{}, end{};
  for (std::size_t i = 0; i < leg.size(); ++i) {
    begin[i] = rig.goal(leg[i]);
    end[i] = startPose(rig.config)[index(leg[i])].value;
  }
  rig.cycle();
  while (rig.state() == State::kKneeling && rig.driven(leg[1])) {
    // The same part of the way is done by each joint.
    const double knee = (rig.goal(leg[1]) - begin[1]) / (end[1] - begin[1]);
    for (std::size_t i = 0; i < leg.size(); ++i)
      ASSERT_NEAR((rig.goal(leg[i]) - begin[i]) / (end[i] - begin[i]), knee, 1e-6) << row(leg[i]).name;
    rig.cycle();
  }
}

TEST(Kneel, WhatTheControllerRequestedForSpeedTorqueAndGainDoesNotSlowOrWeakenIt) {
  Rig rig{exitBy(OnExit::kKneel)};
  stand(rig);
  for (JointCommand& joint : rig.commands.joint) {
    joint.setSpeedLimit(RadPerSec{0.1});
    joint.setTorqueLimit(NewtonMeter{0.01});
    joint.setPGain(0);
  }
  rig.cycle();
  rig.commands.end_of_session = true;
  rig.cycle();
  ASSERT_EQ(rig.state(), State::kKneeling);
  const SafeCommands::JointGoal& knee = rig.safe->goal(Joint::kLegLowerR);
  EXPECT_DOUBLE_EQ(knee.speed_limit.value, rig.config.gentle_speed);
  EXPECT_DOUBLE_EQ(knee.torque_limit.value, rig.config.default_torque);
  EXPECT_DOUBLE_EQ(knee.p_gain, rig.config.default_p_gain);
}

TEST(Release, TheButtonReleasesARobotThatSomebodyElseLeftStiff) {
  Rig rig;
  for (FakeServo& servo : rig.robot.servo) servo.torque = true;  // its controller was killed
  rig.runFor(1);
  EXPECT_EQ(rig.state(), State::kFoundStiff) << "without a driver";
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque) << "and it is left as it is";
  rig.robot.buttons = 1;
  rig.runFor(1);
  expectLimp(rig);
  rig.robot.buttons = 0;
  rig.runFor(2);
  EXPECT_EQ(rig.safe->write(), Write::kNothing) << "once is enough";
}

TEST(Kneel, ItRestsForASecondBeforeItReleasesTorque) {
  Rig rig;
  rig.start();
  rig.commands.end_of_session = true;
  const int cycles = rig.runUntil([&] { return rig.state() == State::kLimp; });
  EXPECT_GE(cycles * 0.016, 0.98);
}

TEST(Kneel, TheEndOfASessionCanHold) {
  Rig rig{exitBy(OnExit::kHold)};
  stand(rig);
  rig.commands.end_of_session = true;
  rig.runFor(20);
  EXPECT_EQ(rig.state(), State::kHolding);
  EXPECT_EQ(rig.goal(Joint::kLegLowerR), 0.3);
  rig.commands = {.session = 2, .start_where_it_is = true};
  EXPECT_TRUE(rig.reach(State::kDriven));
  EXPECT_NEAR(rig.robot[Joint::kLegLowerR].position, 0.3, 0.01);
}

TEST(Kneel, TheEndOfASessionCanReleaseTorqueAtOnce) {
  Rig rig{exitBy(OnExit::kLimp)};
  stand(rig);
  rig.commands.end_of_session = true;
  rig.cycle();
  EXPECT_EQ(rig.safe->write(), Write::kTorque);
  EXPECT_TRUE(rig.safe->torqueOff().all());
  expectLimp(rig);
}

TEST(Kneel, AControllerThatIsGoneIsHeldThenTheRobotKneelsThenItIsLimp) {
  Rig rig;
  stand(rig);
  rig.steps = false;
  EXPECT_NEAR(rig.runUntil([&] { return rig.state() == State::kHolding; }) * 0.016, 0.5, 0.03);
  EXPECT_TRUE(rig.active(Fault::kControllerStalled));
  EXPECT_NEAR(rig.runUntil([&] { return rig.state() == State::kKneeling; }) * 0.016, 9.5, 0.03);
  EXPECT_TRUE(rig.active(Fault::kControllerGone));
  EXPECT_EQ(rig.report().worst, Fault::kControllerGone);
  ASSERT_TRUE(rig.reach(State::kLimp));
  expectLimp(rig);
  rig.runFor(3);
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST(Kneel, ANewSessionBreaksOffTheKneelOfAControllerThatIsGone) {
  Rig rig;
  stand(rig);
  rig.steps = false;
  ASSERT_TRUE(rig.reach(State::kKneeling));
  rig.run(10);
  rig.steps = true;
  rig.newSession();
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kTakingOver);
  EXPECT_TRUE(rig.reach(State::kDriven));
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Kneel, AControllerThatWasGivenUpDoesNotDriveAgainAndANewSessionDoes) {
  for (const int cycles_of_kneel : {20, 2000}) {
    Rig rig;
    stand(rig);
    rig.steps = false;
    ASSERT_TRUE(rig.reach(State::kKneeling));
    rig.run(cycles_of_kneel);
    rig.steps = true;
    ASSERT_TRUE(rig.reach(State::kLimp)) << "also when it returns in the middle of the kneel";
    rig.runFor(20);
    expectLimp(rig);
    EXPECT_TRUE(rig.report().controller_must_end);
    rig.newSession();
    ASSERT_TRUE(rig.reach(State::kDriven));
    EXPECT_FALSE(rig.report().controller_must_end);
    rig.runFor(3);
    EXPECT_NEAR(rig.robot[Joint::kLegLowerR].position, 0.3, 0.01);
  }
}

TEST(Kneel, AControllerThatReturnsBeforeItIsGivenUpDrivesOn) {
  Rig rig;
  stand(rig);
  rig.steps = false;
  rig.runFor(9.9);
  ASSERT_EQ(rig.state(), State::kHolding);
  rig.steps = true;
  EXPECT_TRUE(rig.reach(State::kDriven));
}

/// The loop ends with it, so nothing would watch a robot that a session's `on_exit = hold` leaves standing.
TEST(Kneel, AtTheEndOfTheLoopTheRobotsOwnExitHolds) {
  for (const bool loop_ends : {false, true}) {
    Rig rig{exitBy(OnExit::kKneel)};
    rig.commands.settings = toSession(exitBy(OnExit::kHold));
    stand(rig);
    EXPECT_EQ(rig.report().at_end, Reaction::kHold);
    rig.commands.end_of_session = true;
    rig.commands.loop_ends = loop_ends;
    EXPECT_TRUE(rig.reach(loop_ends ? State::kLimp : State::kHolding));
  }
}

TEST(Kneel, ARobotThatLosesItsPowerInTheKneelIsNotRaisedAgain) {
  Rig rig;
  stand(rig);
  rig.commands.end_of_session = true;
  rig.run(10);
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.run(5);
  rig.robot.power_obeys = true;
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kLimp);
    ASSERT_TRUE(rig.safe->driven().none());
  }
}

TEST(Kneel, AJointThatIsRequestedLimpStaysLimpInTheKneel) {
  Rig rig;
  stand(rig);
  rig.joint(Joint::kShoulderR).setTorque(false);
  rig.run(3);
  rig.commands.end_of_session = true;
  while (rig.state() != State::kLimp) {
    rig.cycle();
    ASSERT_FALSE(rig.driven(Joint::kShoulderR));
  }
}

TEST(Kneel, AnEndingControllerDoesNotMakeAKneelingRobotDrop) {
  Rig rig{exitBy(OnExit::kLimp)};
  stand(rig);
  rig.robot.volt = 9.5;
  ASSERT_TRUE(rig.reach(State::kKneeling));
  EXPECT_TRUE(rig.report().controller_must_end);
  rig.commands.end_of_session = true;
  rig.run(5);
  EXPECT_EQ(rig.state(), State::kKneeling);
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(Kneel, ABlockedJointDoesNotMakeItKneelForever) {
  Rig rig;
  stand(rig);
  rig.robot[Joint::kLegLowerR].follows = false;
  rig.commands.end_of_session = true;
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(Kneel, TheButtonReleasesAllJointsAtOnceAndStaysReleased) {
  Rig rig;
  stand(rig);
  rig.robot.buttons = 1;
  const int cycles = rig.runUntil([&] { return rig.state() == State::kLimp; });
  EXPECT_GE(cycles * 0.016, 0.25);
  EXPECT_LE(cycles * 0.016, 0.30);
  EXPECT_TRUE(rig.safe->torqueOff().all());
  EXPECT_TRUE(rig.report().controller_must_end);
  rig.robot.buttons = 0;
  rig.runFor(2);
  expectLimp(rig);
  EXPECT_TRUE(rig.active(Fault::kReleasedByButton));
  rig.newSession();
  EXPECT_TRUE(rig.reach(State::kDriven)) << "by a new session";
}

TEST(Kneel, AfterAReleaseAResetLeadsThroughTheStartPose) {
  Rig rig;
  stand(rig);
  rig.robot.buttons = 1;
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.robot.buttons = 0;
  rig.run(3);
  ++rig.commands.fault_resets;
  ASSERT_TRUE(rig.reach(State::kTakingOver));
  EXPECT_TRUE(rig.runUntil([&] { return rig.state() != State::kTakingOver; }) >= 0);
  EXPECT_EQ(rig.state(), State::kStarting);
}

TEST(Kneel, TimeInWhichTheBoardIsSilentDoesNotCountAsPressed) {
  Rig rig;
  rig.start();
  rig.robot.buttons = 1;
  rig.run(13);
  rig.robot.board_answers = false;
  rig.run(5);
  rig.robot.board_answers = true;
  rig.robot.buttons = 0;
  rig.runFor(1);
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST(Kneel, AShortPressOrTheOtherButtonReleasesNothing) {
  Rig rig;
  rig.start();
  rig.robot.buttons = 1;
  rig.runFor(0.2);
  rig.robot.buttons = 2;
  rig.runFor(2);
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST(Kneel, TheReleaseButtonCanBeGivenToTheController) {
  Config config;
  config.release_button = ReleaseButton::kNone;
  Rig rig{config};
  rig.start();
  rig.robot.buttons = 1;
  rig.runFor(2);
  EXPECT_EQ(rig.state(), State::kDriven);
}

}  // namespace
}  // namespace darwinop::safety
