// The supply of servos without a board, from their replies and polls.
#include "safety/supply_watch.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>
#include <initializer_list>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr Nanos kCycle{16'000'000};

struct Servos : ::testing::Test {
  Servos() {
    for (JointSensors& joint : seen.joint) {
      joint.voltage = Volt{12};
      joint.speed_limit = RadPerSec{1};
    }
    cycle();
  }
  /// One cycle in which every servo replies and is polled, but for `silent`.
  void cycle(std::initializer_list<std::size_t> silent = {}) {
    for (JointSensors& joint : seen.joint) joint.motion = joint.polled = Freshness{0};
    for (const std::size_t i : silent) seen.joint[i].motion = seen.joint[i].polled = Freshness{1};
    watch.update(seen, kCycle);
  }
  /// Of the first `count` servos: each misses a reply and comes back in its power-up state.
  void restart(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) restartOne(i);
  }
  void restartOne(std::size_t i) {
    cycle({i});
    seen.joint[i].speed_limit = RadPerSec{0};
    cycle();
    interrupted = interrupted || watch.interruptedNow();
    seen.joint[i].speed_limit = RadPerSec{1};  // taken over again
  }

  Sensors seen;
  SupplyWatch watch{false};
  bool interrupted = false;
};

TEST_F(Servos, HalfOfThemThatRestartWithinASecondMeanThatTheSupplyWasInterrupted) {
  restart(kJoints / 2 - 1);
  EXPECT_FALSE(interrupted);
  restartOne(kJoints - 1);
  EXPECT_TRUE(interrupted);
  cycle();
  EXPECT_FALSE(watch.interruptedNow()) << "it is reported once";
}

TEST_F(Servos, RestartsFarApartAreThoseOfTheirJoints) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    restartOne(i);
    for (Nanos waited{0}; waited < SupplyWatch::kTogether; waited += kCycle) cycle();
  }
  EXPECT_FALSE(interrupted);
}

TEST_F(Servos, DamagedReadingsOfServosThatMissedNoReplyDoNotCount) {
  for (JointSensors& joint : seen.joint) joint.speed_limit = RadPerSec{0};
  cycle();
  EXPECT_FALSE(watch.interruptedNow());
}

TEST_F(Servos, ThatNoLoopHasDrivenDoNotCount) {
  SupplyWatch fresh{false};
  for (JointSensors& joint : seen.joint) joint.speed_limit = RadPerSec{0};
  for (int i = 0; i < 3; ++i) {
    for (JointSensors& joint : seen.joint) joint.motion = joint.polled = Freshness{i == 1 ? 1U : 0U};
    fresh.update(seen, kCycle);
    EXPECT_FALSE(fresh.interruptedNow());
  }
}

TEST_F(Servos, ThatRestartRightAfterTheirFirstGoalCount) {
  SupplyWatch fresh{false};
  const auto cycle = [&](bool reply) {
    for (JointSensors& joint : seen.joint) joint.motion = joint.polled = Freshness{reply ? 0U : 1U};
    fresh.update(seen, kCycle);
  };
  for (JointSensors& joint : seen.joint) joint.speed_limit = RadPerSec{0};
  cycle(false);
  cycle(true);
  fresh.noteGoals(std::bitset<kJoints>{}.set());
  cycle(true);
  EXPECT_FALSE(fresh.interruptedNow()) << "the goal was lost; the reply was missed before it";
  cycle(false);
  cycle(true);
  EXPECT_FALSE(fresh.interruptedNow()) << "no goal has arrived";
  fresh.noteGoals(std::bitset<kJoints>{}.set());
  cycle(false);
  cycle(true);
  EXPECT_TRUE(fresh.interruptedNow());
}

TEST_F(Servos, ThatHadTorqueWithoutASpeedLimitCount) {
  SupplyWatch fresh{false};
  for (const bool torque : {true, false}) {
    for (JointSensors& joint : seen.joint) {
      joint.speed_limit = RadPerSec{0};
      joint.torque_enabled = torque;
      joint.motion = joint.polled = Freshness{torque ? 0U : 1U};
    }
    fresh.update(seen, kCycle);
  }
  for (JointSensors& joint : seen.joint) joint.motion = joint.polled = Freshness{0};
  fresh.update(seen, kCycle);
  EXPECT_TRUE(fresh.interruptedNow());
}

TEST_F(Servos, OfAnEarlierLoopThatHeldThemCountAtOnce) {
  SupplyWatch next{true};
  for (JointSensors& joint : seen.joint) joint.speed_limit = RadPerSec{0};
  next.update(seen, kCycle);
  EXPECT_TRUE(next.interruptedNow());
}

TEST_F(Servos, ThatHaveBeenSilentForLongAreNotAmongTheHalf) {
  for (std::size_t i = 4; i < kJoints; ++i) seen.joint[i].motion = Freshness{100};
  for (int i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      seen.joint[j].motion = seen.joint[j].polled = Freshness{i == 0 ? 1U : 0U};
      seen.joint[j].speed_limit = RadPerSec{j < 2 && i == 1 ? 0.0 : 1.0};
    }
    watch.update(seen, kCycle);
  }
  EXPECT_TRUE(watch.interruptedNow()) << "two of four";
}

TEST_F(Servos, TheVoltageIsTheirMedianAndOldReadingsAreNone) {
  seen.joint[0].voltage = Volt{0};
  seen.joint[1].voltage = Volt{25};
  cycle();
  EXPECT_EQ(watch.voltage(), 12);
  for (JointSensors& joint : seen.joint) joint.polled = Freshness{SupplyWatch::kRecent + 1};
  seen.joint[1].polled = Freshness{0};
  watch.update(seen, kCycle);
  EXPECT_EQ(watch.voltage(), 25) << "the only recent one";
}

struct GuardWithoutBoard : ::testing::Test {
  GuardWithoutBoard() { rig.robot.board = false; }
  Rig rig;
};

/// Only a poll shows whether a servo has restarted. With a board, its power bit does.
TEST_F(GuardWithoutBoard, ASessionWaitsAfterAnOutageUntilTheServosWerePolled) {
  rig.start();
  rig.run(30);
  rig.robot.board_answers = false;
  ASSERT_TRUE(rig.reach(State::kOffline));
  for (FakeServo& servo : rig.robot.servo) servo.polled = false;
  rig.robot.board_answers = true;
  for (int i = 0; i < 40; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kOffline) << i;
  }
  for (FakeServo& servo : rig.robot.servo) servo.polled = true;
  EXPECT_TRUE(rig.reach(State::kDriven));
}

/// The goal that is placed switches torque on, and the poll that would have shown its speed limit shows a restart.
TEST_F(GuardWithoutBoard, ASupplyThatIsCutRightAfterTheFirstGoalReleasesTheRobot) {
  rig.robot.goal_write_switches_on = true;
  for (FakeServo& servo : rig.robot.servo) servo.restarted = true;  // just supplied
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.newSession();
  for (FakeServo& servo : rig.robot.servo) servo.polled = false;
  ASSERT_GE(rig.runUntil([&] { return rig.robot.servo[0].torque; }), 0);
  rig.robot.servo_power = false;
  for (FakeServo& servo : rig.robot.servo) servo.polled = servo.restarted = true;
  rig.run(12);  // a servo boots for 0.2 s
  rig.robot.servo_power = true;
  rig.runFor(2);
  EXPECT_TRUE(rig.active(Fault::kBoardReset));
  for (const FakeServo& servo : rig.robot.servo) ASSERT_FALSE(servo.torque);
}

TEST_F(GuardWithoutBoard, IsDrivenAndKneelsAtTheEndAsWithOne) {
  rig.start();
  rig.commands.end_of_session = true;
  EXPECT_TRUE(rig.reach(State::kKneeling));
  EXPECT_TRUE(rig.reach(State::kLimp));
  EXPECT_FALSE(rig.safe->powerOn());
}

}  // namespace
}  // namespace darwinop::safety
