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

TEST(TakeOver, NoTorqueFindsAnOlderGoalWhateverIsLostOnTheWire) {
  // Left over from an earlier program: the goal, in ticks from where the joint is, and its speed. 0: powered up.
  for (const double away : {900.0, 3.0, 0.0}) {
    for (const double speed : {0.0, 1.0, 12.0}) {
      if (away == 0 && speed == 1) continue;  // what is written as well
      Rig rig;
      FakeServo& neck = rig.robot[Joint::kNeck];
      neck.goal = neck.position + away * kRadPerTick;
      neck.speed = speed;
      neck.restarted = speed == 0;
      neck.receives = false;
      rig.newSession();
      for (int i = 0; i < 300; ++i) {
        rig.cycle();
        ASSERT_FALSE(rig.safe->torqueOn()[index(Joint::kNeck)]) << "cycle " << i;
      }
      EXPECT_TRUE(rig.robot[Joint::kHead].torque) << "the others are not kept waiting";
      EXPECT_TRUE(rig.active(Fault::kServoSilent)) << away << " ticks, " << speed << " rad/s: it is reported";
      EXPECT_EQ(rig.report().worst_joint, 19);
      neck.receives = true;
      rig.run(10);
      EXPECT_TRUE(neck.torque);
      EXPECT_FALSE(rig.active(Fault::kServoSilent));
    }
  }
}

TEST(TakeOver, TorqueWaitsForTheReplyOfTheBoard) {
  const auto cycles_until_placed = [] {
    Rig rig;
    rig.newSession();
    return rig.runUntil([&] { return rig.safe && rig.driven(Joint::kNeck); });
  };
  Rig rig;
  rig.newSession();
  rig.run(cycles_until_placed() - 1);
  rig.robot.board_reply_lost = true;
  rig.cycle();  // goals are written and seen in the servos; the board's reply is missing
  ASSERT_TRUE(rig.driven(Joint::kNeck));
  rig.robot.board_reply_lost = false;
  rig.cycle();
  EXPECT_TRUE(rig.safe->torqueOn().none());
  rig.run(3);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
}

TEST(TakeOver, ALostTorqueOnIsSeenAtTheNextPollAndRepeated) {
  const auto ordered = [](Rig& rig) { return rig.safe && rig.safe->torqueOn()[index(Joint::kNeck)]; };
  Rig undisturbed;
  undisturbed.newSession();
  const int cycles = undisturbed.runUntil([&] { return ordered(undisturbed); });
  ASSERT_GT(cycles, 1);
  Rig rig;
  rig.newSession();
  rig.run(cycles - 1);
  rig.robot[Joint::kNeck].receives = false;
  rig.cycle();
  ASSERT_TRUE(ordered(rig));
  rig.robot[Joint::kNeck].receives = true;
  rig.run(8);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
}

TEST(TakeOver, AServoWhoseTorqueGoesOffSoonAfterItCameOnIsTakenOverAgain) {
  Rig rig;
  rig.newSession();
  ASSERT_GE(rig.runUntil([&] { return rig.robot[Joint::kNeck].torque; }), 0);
  rig.run(2);  // it was seen with torque
  rig.robot[Joint::kNeck].torque = false;
  rig.runFor(2);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
  EXPECT_FALSE(rig.active(Fault::kServoOverload));
}

TEST(TakeOver, AServoThatShutsItselfOffAtOnceIsTriedTwiceAndThenBelieved) {
  Rig rig;
  rig.robot[Joint::kNeck].shuts_off = true;
  rig.newSession();
  int tries = 0;
  bool was_driven = false;
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.safe->torqueOn()[index(Joint::kNeck)]);
    tries += rig.driven(Joint::kNeck) && !was_driven ? 1 : 0;
    was_driven = rig.driven(Joint::kNeck);
  }
  EXPECT_EQ(tries, 2);
  EXPECT_TRUE(rig.report().tripped[index(Joint::kNeck)]);
  EXPECT_TRUE(rig.active(Fault::kServoOverload));
}

TEST(TakeOver, NoTorqueComesOnAtAServoWithoutTheGentleSpeed) {
  for (const double speed : {0.0, 5.0}) {
    Rig rig;
    rig.run(5);
    rig.newSession();
    ASSERT_GE(rig.runUntil([&] { return rig.safe->write() == Write::kGoals; }), 0);
    FakeServo& neck = rig.robot[Joint::kNeck];
    rig.robot.seen.joint[index(Joint::kNeck)].speed_limit = RadPerSec{speed};
    rig.cycle();
    EXPECT_EQ(rig.safe->write(), Write::kTorque);
    EXPECT_FALSE(rig.safe->torqueOn()[index(Joint::kNeck)]) << speed;
    rig.run(10);
    EXPECT_TRUE(neck.torque);
  }
}

TEST(TakeOver, ACorruptedReadingNeverBecomesAGoal) {
  for (int when = 0; when < 12; ++when) {
    Rig rig;
    rig.commands.start_where_it_is = true;
    rig.newSession();
    rig.run(when);
    const double truth = rig.robot[Joint::kNeck].position;
    rig.robot[Joint::kNeck].corruption = 0.8;
    for (int i = 0; i < 20; ++i) {
      rig.cycle();
      if (rig.driven(Joint::kNeck)) {
        ASSERT_NEAR(rig.goal(Joint::kNeck), truth, 0.03) << "corrupted in cycle " << when;
      }
    }
  }
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

TEST(TakeOver, AGoalStaysInItsPlaceUntilTorqueIsSeen) {
  Rig rig;
  rig.robot[Joint::kHead].answers = false;
  rig.robot[Joint::kHead].position = 0.9;
  rig.start();
  rig.joint(Joint::kHead).setGoal(Rad{0});
  rig.robot[Joint::kHead].answers = true;
  ASSERT_GE(rig.runUntil([&] { return rig.safe->torqueOn()[index(Joint::kHead)]; }), 0);
  const double placed = rig.goal(Joint::kHead);
  for (int i = 0; i < 5; ++i) {
    rig.robot.seen.joint[index(Joint::kHead)].health.missed();  // position only
    rig.cycle();
    ASSERT_EQ(rig.goal(Joint::kHead), placed) << i;
  }
  rig.run(5);
  EXPECT_LT(rig.goal(Joint::kHead), placed);
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

TEST(TakeOver, TorqueComesOnOnlyAfterAGoalThatTheBoardReceived) {
  Rig rig;
  rig.newSession();
  rig.run(4);
  ASSERT_EQ(rig.safe->write(), Write::kNothing);
  for (FakeServo& servo : rig.robot.servo) servo.goal = 3;  // left over from an earlier program: would be a jump
  rig.robot.board_answers = false;                          // whatever is written now is lost
  rig.cycle();
  ASSERT_EQ(rig.safe->write(), Write::kGoals);
  for (int i = 0; i < 3; ++i) {
    rig.cycle();
    ASSERT_TRUE(rig.safe->driven().none()) << "where they are is not certain any more, " << i;
  }
  rig.joint(Joint::kHead).setTorque(false);
  rig.cycle();
  EXPECT_EQ(rig.safe->write(), Write::kTorque);
  EXPECT_TRUE(rig.safe->torqueOn().none()) << "off goes out in any case, on does not";
  rig.robot.board_answers = true;
  ASSERT_GE(rig.runUntil([&] { return rig.safe->torqueOn().any(); }), 0);
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (rig.safe->torqueOn()[i]) {
      EXPECT_NEAR(rig.robot.servo[i].goal, rig.robot.servo[i].position, 0.03);
    }
  }
}

TEST(TakeOver, ALostTorqueOnIsSentAgain) {
  Rig rig;
  rig.newSession();
  ASSERT_GE(rig.runUntil([&] { return rig.safe->write() == Write::kGoals; }), 0);
  rig.robot[Joint::kNeck].receives = false;  // just that one frame is lost
  rig.cycle();
  ASSERT_EQ(rig.safe->write(), Write::kTorque);
  rig.robot[Joint::kNeck].receives = true;
  rig.runFor(2.5);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
  EXPECT_FALSE(rig.active(Fault::kServoOverload));
}

}  // namespace
}  // namespace darwinop::safety
