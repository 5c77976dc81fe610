// The judge at the servos: what it tolerates after a restart, beside a duplicate id and after a takeover, and no more.
#include "campaign/servo_judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/conversions.hpp"
#include "core/registers.hpp"

namespace darwinop {
namespace {

/// One servo. Each test starts in a cycle in which it is driven, and has torque, a speed limit and a goal.
struct Judged : ::testing::Test {
  static constexpr Joint kJoint = Joint::kNeck;
  static constexpr std::uint16_t kStart = 2048;

  hil::VirtualRobot robot;
  safety::Config config;
  ServoJudge judge{robot, config};
  Commands asked;
  Sensors seen;
  hil::ServoState servo{true, true, 1023, kStart, 100};
  const int step = static_cast<int>(config.max_joint_speed * 0.016 / kRadPerTick);

  Judged() {
    seen.joint[index(kJoint)].motion.age = 0;
    seen.joint[index(kJoint)].driven = true;
    seen.safety.state = State::kDriven;
    cycles(30);
  }

  /// Cycles in which nothing is written.
  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      judge.endCycle(seen);
      judge.beginCycle(asked);
    }
  }
  void send(std::uint8_t address, const std::vector<std::uint8_t>& data) {
    std::vector<std::uint8_t> params{address, static_cast<std::uint8_t>(data.size()), row(kJoint).id};
    params.insert(params.end(), data.begin(), data.end());
    judge.request(Frame{kBroadcastId, static_cast<std::uint8_t>(Instruction::kSyncWrite), params}, Nanos{0});
  }
  static std::vector<std::uint8_t> bytesOf(std::uint16_t word) { return {lowByte(word), highByte(word)}; }

  void sendGoal(std::uint16_t goal) { send(servo::kGoalPosition, bytesOf(goal)); }
  void goalArrives(std::uint16_t goal) {
    const hil::ServoState before = servo;
    servo.goal = goal;
    servo.torque_enable = true;
    judge.written(kJoint, servo::kGoalPosition, bytesOf(goal), before, servo);
  }
  void writeGoal(std::uint16_t goal) {
    sendGoal(goal);
    goalArrives(goal);
  }
  void writeTorqueOn() {
    send(servo::kTorqueEnable, {1});
    judge.written(kJoint, servo::kTorqueEnable, std::array<std::uint8_t, 1>{1}, servo, servo);
  }
  void restart() {
    hil::ServoState before = servo;
    servo.powered = servo.torque_enable = false;
    judge.changed(kJoint, hil::ServoEvent::kPowerOff, before, servo);
    before = servo;
    servo.powered = true;
    servo.speed = 0;
    judge.changed(kJoint, hil::ServoEvent::kPowerOn, before, servo);
  }
  void trip() {
    hil::ServoState off = servo;
    off.torque_enable = false;
    off.torque_limit = 0;
    judge.changed(kJoint, hil::ServoEvent::kTripped, servo, off);
  }
};

struct RestartBetweenTwoAnswers : Judged {
  /// Two goals are lost, the servo restarts, and a third goal arrives.
  void moveBy(int ticks) {
    writeGoal(kStart);
    sendGoal(kStart);
    sendGoal(kStart);
    restart();
    cycles(1);
    writeGoal(static_cast<std::uint16_t>(kStart + ticks));
  }
};

TEST_F(RestartBetweenTwoAnswers, AllowsAStepForEachGoalThatWasSent) {
  moveBy(3 * step);
  EXPECT_EQ(judge.failure(), "");
}

TEST_F(RestartBetweenTwoAnswers, AllowsNoMore) {
  moveBy(4 * step);
  EXPECT_NE(judge.failure(), "");
}

/// A damaged write makes the servo's state unknown for 80 cycles. It restarts towards their end.
struct RestartWhileUntrusted : Judged {
  RestartWhileUntrusted() {
    judge.written(kJoint, servo::kGoalPosition, bytesOf(99), servo, servo);
    cycles(boundAs<int>(Leniency::kUntrusted) - 2);
    restart();
    writeGoal(kStart);
  }
};

TEST_F(RestartWhileUntrusted, LeavesAPollRoundForTheSpeedLimit) {
  cycles(4);
  writeGoal(kStart);
  EXPECT_EQ(judge.failure(), "");
}

TEST_F(RestartWhileUntrusted, IsBlamedAfterwards) {
  cycles(boundAs<int>(Leniency::kNoSpeedLimit) + 1);
  writeGoal(kStart);
  EXPECT_NE(judge.failure(), "");
}

using ShutdownAfterATakeover = Judged;

TEST_F(ShutdownAfterATakeover, IsEarlyIfTorqueWasSwitchedOnJustBefore) {
  for (int i = 0; i < 3; ++i) {
    writeTorqueOn();
    cycles(boundAs<int>(Leniency::kEarlyBit));
    trip();
  }
  EXPECT_EQ(judge.failure(), "");
}

TEST_F(ShutdownAfterATakeover, IsToleratedOnceLater) {
  writeTorqueOn();
  cycles(boundAs<int>(Leniency::kEarlyBit) + 1);
  trip();
  EXPECT_EQ(judge.failure(), "");
  trip();
  EXPECT_NE(judge.failure(), "");
}

}  // namespace
}  // namespace darwinop
