// How a robot comes under control: nothing, then goals at the present pose, then torque, then the start pose.
#include <gtest/gtest.h>

#include "safety/rig.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::safety {
namespace {

TEST(TakeOver, BeforeTheFirstCycleNothingIsSent) {
  Guard guard{Config{}};
  const SafeCommands safe = guard.vet(Commands{}, Sensors{});
  EXPECT_EQ(safe.write(), Write::kNothing);
  EXPECT_FALSE(safe.powerOn());
  EXPECT_EQ(guard.report().state, State::kOffline);
}

TEST(TakeOver, WithoutADriverNothingIsEverSent) {
  Rig rig;
  rig.commands.joint[0].setGoal(Rad{1});
  for (int i = 0; i < 500; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.safe->write(), Write::kNothing);
  }
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(TakeOver, GoalIsThePresentPositionAndTorqueComesWhenTheServosAreSeenToHaveIt) {
  Rig rig;
  rig.run(5);
  rig.newSession();
  ASSERT_GE(rig.runUntil([&] { return rig.safe->write() != Write::kNothing; }), 0);
  EXPECT_EQ(rig.safe->write(), Write::kGoals);
  EXPECT_TRUE(rig.safe->driven().all());
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto& goal = rig.safe->goal(static_cast<Joint>(i));
    EXPECT_NEAR(goal.goal.value, rig.robot.servo[i].position, kRadPerTick) << i;
    EXPECT_NEAR(goal.speed_limit.value, 1.194, 1e-9);
    EXPECT_FALSE(rig.robot.servo[i].torque);
  }
  EXPECT_TRUE(rig.safe->poll().all());
  rig.cycle();
  EXPECT_EQ(rig.safe->write(), Write::kTorque);
  EXPECT_TRUE(rig.safe->torqueOn().all());
}

/// Ctrl-C, or a controller that fails at its start.
TEST(TakeOver, ALimpRobotStaysLimpIfTheSessionEndsBeforeTorqueIsOn) {
  for (const OnExit how : {OnExit::kHold, OnExit::kKneel, OnExit::kLimp})
    for (const bool has_neck : {true, false}) {
      Config config;
      config.on_exit = how;
      config.absent.set(index(Joint::kNeck), !has_neck);
      Rig rig{config};
      rig.robot[Joint::kNeck].answers = has_neck;
      rig.robot.goal_write_switches_on = true;
      rig.run(60);
      rig.newSession();
      rig.cycle();
      ASSERT_EQ(rig.state(), State::kTakingOver);
      rig.commands.end_of_session = true;
      for (int i = 0; i < 1000; ++i) {
        rig.cycle();
        for (const FakeServo& servo : rig.robot.servo) ASSERT_FALSE(servo.torque) << i;
      }
      EXPECT_EQ(rig.state(), State::kLimp);
    }
}

TEST(TakeOver, AStandingRobotSitsDownIfTheSessionEndsAtOnce) {
  Rig rig;
  for (FakeServo& servo : rig.robot.servo) servo.torque = true;
  rig.run(60);
  ASSERT_EQ(rig.state(), State::kFoundStiff);
  rig.newSession();
  rig.cycle();
  ASSERT_EQ(rig.state(), State::kTakingOver);
  rig.commands.end_of_session = true;
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kKneeling);
}

TEST(TakeOver, ThenAllJointsMoveSlowlyToTheStartPose) {
  Rig rig;
  rig.robot[Joint::kShoulderR].position += 1.5;
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kStarting));
  double last = rig.robot[Joint::kShoulderR].position;
  double fastest = 0;
  while (rig.state() == State::kStarting) {
    rig.cycle();
    fastest = std::max(fastest, std::abs(rig.robot[Joint::kShoulderR].position - last) / 0.016);
    last = rig.robot[Joint::kShoulderR].position;
  }
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_LE(fastest, 1.194 + 1e-6);
  EXPECT_GT(fastest, 1.0);
  const auto pose = startPose(rig.config);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.robot.servo[i].position, pose[i].value, 0.002) << i;
  EXPECT_EQ(rig.report().start_timeouts, 0u);
  rig.run(20);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_EQ(rig.safe->goal(static_cast<Joint>(i)).goal, pose[i]) << i;
}

TEST(TakeOver, TheStartMoveIsAsSlowWhateverTheControllerAsks) {
  Rig rig;
  for (auto& joint : rig.commands.joint) {
    joint.setGoal(Rad{0});
    joint.setSpeedLimit(RadPerSec{12});
  }
  rig.newSession();
  while (rig.state() != State::kDriven) {
    rig.cycle();
    if (rig.state() == State::kStarting) {
      ASSERT_NEAR(rig.safe->goal(Joint::kNeck).speed_limit.value, 1.194, 1e-9);
    }
  }
}

TEST(TakeOver, AJointThatDoesNotGetToTheStartPoseIsReportedAndNotWaitedForForever) {
  Rig rig;
  rig.robot[Joint::kHead].position += 0.4;
  rig.robot[Joint::kHead].follows = false;
  rig.newSession();
  const int cycles = rig.runUntil([&] { return rig.state() == State::kDriven; });
  ASSERT_GE(cycles, 0);
  EXPECT_LT(cycles * 0.016, 0.5 * 1.5 / 1.194 + 3);
  EXPECT_EQ(rig.report().start_timeouts, 1u);
  EXPECT_EQ(rig.report().missed_start.count(), 1u);
  EXPECT_TRUE(rig.report().missed_start[index(Joint::kHead)]);
}

TEST(TakeOver, AJointThatArrivesASecondAfterTheOthersIsWaitedFor) {
  Rig rig;
  rig.robot[Joint::kHead].position += 0.4;
  rig.robot[Joint::kHead].follows = false;
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kStarting));
  rig.runFor(1.5);
  rig.robot[Joint::kHead].follows = true;
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_EQ(rig.report().start_timeouts, 0u);
}

TEST(TakeOver, ALongWayGetsTheTimeItTakes) {
  Config config;
  config.gentle_speed = 0.2;
  Rig rig{config};
  rig.robot[Joint::kHead].position += 0.7;
  rig.start();
  EXPECT_NEAR(rig.robot[Joint::kHead].position, radFromTicks(2173).value, 0.005);
  EXPECT_EQ(rig.report().start_timeouts, 0u);
}

TEST(TakeOver, StartWhereItIsSkipsTheMove) {
  for (const bool by_config : {false, true}) {
    Config config;
    if (by_config) config.start = StartMove::kHold;
    Rig rig{config};
    rig.commands.start_where_it_is = !by_config;
    const double before = rig.robot[Joint::kNeck].position;
    rig.newSession();
    while (rig.state() != State::kDriven) {
      rig.cycle();
      ASSERT_NE(rig.state(), State::kStarting);
    }
    rig.run(100);
    EXPECT_NEAR(rig.robot[Joint::kNeck].position, before, kRadPerTick);
  }
}

TEST(TakeOver, AfterStartingInPlaceTheFirstMoveIsGentle) {
  Rig rig;
  rig.commands.start_where_it_is = true;
  rig.joint(Joint::kNeck).setGoal(Rad{1.2});
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kDriven));
  double last = rig.goal(Joint::kNeck);
  while (last < 1.2) {
    rig.cycle();
    ASSERT_LE(rig.goal(Joint::kNeck) - last, 1.194 * 0.016 + 1e-9);
    last = rig.goal(Joint::kNeck);
    ASSERT_TRUE(last == 1.2 || rig.safe->goal(Joint::kNeck).speed_limit.value <= 1.194 + 1e-9);
  }
  rig.run(2);
  EXPECT_GT(rig.safe->goal(Joint::kNeck).speed_limit.value, 12) << "caught up";
}

TEST(TakeOver, AJointThatNeverAnsweredIsLeftOutReportedAndJoinsLaterGently) {
  Rig rig;
  rig.robot[Joint::kHead].answers = false;
  rig.robot.given_up.set(index(Joint::kHead));
  rig.robot[Joint::kHead].position = 0.9;
  rig.start();
  EXPECT_FALSE(rig.driven(Joint::kHead));
  EXPECT_FALSE(rig.robot[Joint::kHead].torque);
  EXPECT_TRUE(rig.active(Fault::kServoSilent));
  EXPECT_EQ(rig.report().worst_joint, 20);
  rig.joint(Joint::kHead).setGoal(Rad{0});
  rig.runFor(1);
  rig.robot[Joint::kHead].answers = true;
  rig.robot.given_up.reset();
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kHead); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kHead), 0.9, kRadPerTick);
  EXPECT_FALSE(rig.active(Fault::kServoSilent));
  double last = rig.goal(Joint::kHead);
  for (int i = 0; i < 20; ++i) {
    rig.cycle();
    ASSERT_LE(last - rig.goal(Joint::kHead), 1.194 * 0.016 + 1e-9);
    last = rig.goal(Joint::kHead);
  }
  rig.runFor(1);
  EXPECT_NEAR(rig.robot[Joint::kHead].position, 0, 1e-9);
}

TEST(TakeOver, ATorqueOffRequestIsRespectedFromTheStart) {
  Rig rig;
  rig.joint(Joint::kShoulderR).setTorque(false);
  rig.robot[Joint::kShoulderR].torque = true;  // left over from an earlier program
  rig.newSession();
  while (rig.state() != State::kDriven) {
    rig.cycle();
    ASSERT_FALSE(rig.driven(Joint::kShoulderR));
    ASSERT_FALSE(rig.safe->torqueOn()[index(Joint::kShoulderR)]);
  }
  EXPECT_FALSE(rig.robot[Joint::kShoulderR].torque);
  EXPECT_EQ(rig.report().start_timeouts, 0u) << "a limp joint is not waited for";
}

TEST(TakeOver, ARobotWithAllJointsRequestedLimpIsTakenOverAllTheSame) {
  Rig rig;
  for (auto& joint : rig.commands.joint) joint.setTorque(false);
  rig.start();
  EXPECT_TRUE(rig.safe->driven().none());
}

TEST(TakeOver, ANewSessionStartsFromTheConfirmedPresentPoseWithoutAJump) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.2});
  rig.joint(Joint::kNeck).setSpeedLimit(RadPerSec{0.5});
  rig.runFor(1);
  const double where = rig.robot[Joint::kNeck].position;
  ASSERT_LT(where, 0.7);
  ASSERT_NEAR(rig.goal(Joint::kNeck), 1.2, 1e-9);
  rig.commands = {.session = 2, .start_where_it_is = true};
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kTakingOver);
  EXPECT_FALSE(rig.driven(Joint::kNeck));
  EXPECT_EQ(rig.report().session, 2u);
  rig.robot[Joint::kNeck].goal = rig.robot[Joint::kNeck].position;  // it came to rest
  const double rest = rig.robot[Joint::kNeck].position;
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_NEAR(rig.goal(Joint::kNeck), rest, 0.015);
  rig.runFor(1);
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, rest, 0.015) << "the requests of the old session are forgotten";
}

TEST(TakeOver, EverySessionGoesThroughTheStartPoseInItsOwnTime) {
  Rig rig;
  for (std::uint32_t session = 1; session <= 4; ++session) {
    rig.commands = {.session = session};
    ASSERT_TRUE(rig.reach(State::kStarting));
    ASSERT_TRUE(rig.reach(State::kDriven));
    EXPECT_NEAR(rig.robot[Joint::kShoulderR].position, radFromTicks(1500).value, 0.01);
    EXPECT_EQ(rig.report().start_timeouts, 0u);
    rig.joint(Joint::kShoulderR).setGoal(Rad{1});
    rig.runFor(1);
  }
}

TEST(TakeOver, EverySessionWaitsForItsJoints) {
  Rig rig;
  rig.robot[Joint::kHead].answers = false;
  rig.start();  // waits a second for the head
  rig.robot[Joint::kHead].answers = true;
  rig.runFor(1);
  rig.newSession();
  rig.robot[Joint::kNeck].answers = false;
  rig.run(20);
  EXPECT_EQ(rig.state(), State::kTakingOver);
  rig.robot[Joint::kNeck].answers = true;
  EXPECT_TRUE(rig.reach(State::kStarting));
  EXPECT_TRUE(rig.safe->driven().all());
}

TEST(TakeOver, WaitsForServoPowerAndAsksForIt) {
  Rig rig;
  rig.robot.servo_power = false;
  rig.robot.power_obeys = false;
  rig.newSession();
  rig.runFor(3);
  EXPECT_EQ(rig.state(), State::kTakingOver);
  EXPECT_TRUE(rig.safe->powerOn());
  EXPECT_TRUE(rig.report().active.none()) << "power that was never on is not lost, and servos without it not silent";
  rig.robot.power_obeys = true;
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_FALSE(rig.safe->powerOn());
}

}  // namespace
}  // namespace darwinop::safety
