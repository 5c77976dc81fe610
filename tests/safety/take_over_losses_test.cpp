// Takeover when writes or replies are lost, readings are wrong, or a servo is not as it was left.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

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
  rig.run(8);  // the next poll finds torque off
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
  rig.runFor(2.5);
  EXPECT_FALSE(rig.active(Fault::kServoOverload));
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
    rig.robot.seen.joint[index(Joint::kHead)].polled.missed();  // position only
    rig.cycle();
    ASSERT_EQ(rig.goal(Joint::kHead), placed) << i;
  }
  rig.run(5);
  EXPECT_LT(rig.goal(Joint::kHead), placed);
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

}  // namespace
}  // namespace darwinop::safety
