// A torque in N m is the same torque at every joint, whichever model its servo is.
#include "hal/cm730/stall_torques.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/servo_models.hpp"
#include "hal/cm730/goal_writer.hpp"
#include "hal/cm730/reply_decoder.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

constexpr double kMx64 = 6.0;

StallTorques neckIsAnMx64() {
  StallTorques stall;
  stall.set(Joint::kNeck, NewtonMeter{kMx64});
  return stall;
}

/// Torque limit of a frame that writes P gain to torque limit of one servo.
int limitIn(std::span<const std::uint8_t> frame) {
  return wordAt(frame, frame.size() - 3);
}

int limitWritten(Joint joint, double newton_meter) {
  GoalWriter writer{{}, neckIsAnMx64()};
  const auto asked = SafeCommandsForTests{}.drive(joint, Rad{0}, RadPerSec{1}, NewtonMeter{newton_meter});
  return limitIn(writer.encode(asked.commands));
}

TEST(StallTorques, AStrongerServoGetsTheTorqueLimitThatWasAskedForAndNotItsOwnMaximum) {
  EXPECT_EQ(limitWritten(Joint::kHead, 2.5), 1023);
  EXPECT_EQ(limitWritten(Joint::kNeck, 2.5), 426) << "2.5 of 6 N m";
  EXPECT_EQ(limitWritten(Joint::kNeck, 1.0), 171) << "170.5";
}

TEST(StallTorques, ALimitOfAStrongerServoIsNeverZeroAsThatMeansThatItHasShutItselfOff) {
  EXPECT_EQ(limitWritten(Joint::kNeck, kMaxTorqueNm / kTorqueMax), 1) << "0.4";
}

TEST(StallTorques, NoModelGetsMoreThanTheLimitByMoreThanACount) {
  for (const ServoModel& model : kServoModels) {
    StallTorques stall;
    stall.set(Joint::kNeck, NewtonMeter{model.stall_torque});
    for (int i = 1; i <= kTorqueMax; ++i) {
      const NewtonMeter limit = torqueFromRegister(static_cast<std::uint16_t>(i));
      const NewtonMeter got = stall.limit(Joint::kNeck, stall.limitRegister(Joint::kNeck, limit));
      ASSERT_LE(got.value, limit.value + model.stall_torque / kTorqueMax) << model.name;
      ASSERT_NEAR(got.value, limit.value, model.stall_torque / kTorqueMax) << model.name;
    }
  }
}

TEST(StallTorques, LoadAndLimitOfAStrongerServoAreReadInTheSameUnits) {
  const std::array<ReadList::Entry, 2> list{{{18, true}, {19, true}}};  // Neck, Head
  BusReadings readings{};
  ReplyDecoder decoder{{}, neckIsAnMx64()};
  decoder.begin(list, 30, readings);
  decoder.take(Frame{kBoardId, 0, std::vector<std::uint8_t>(30, 0)});
  std::vector<std::uint8_t> poll(20, 0);
  poll[10] = 0xAA, poll[11] = 0x01;  // 34: 426
  poll[16] = 0xD5, poll[17] = 0x04;  // 40: 213 clockwise
  for (const std::uint8_t id : std::array<std::uint8_t, 2>{19, 20}) decoder.take(Frame{id, 0, poll});
  const ServoReading &neck = readings.servo[18], &head = readings.servo[19];
  EXPECT_NEAR(neck.torque_limit.value, 2.5, 0.003);
  EXPECT_NEAR(head.torque_limit.value, 2.5 * 426 / 1023, 1e-9);
  EXPECT_NEAR(neck.load * kMaxTorqueNm, -kMx64 * 213 / 1023, 1e-9) << "N m";
  EXPECT_NEAR(head.load, -213.0 / 1023, 1e-9);
}

TEST(StallTorques, AStrongerServoWorksAtItsLimitWhenItsLoadReachesItsLimit) {
  GoalWriter writer{{}, neckIsAnMx64()};
  SafeCommandsForTests asked;
  for (int i = 0; i < 200; ++i)
    (void)writer.encode(asked.drive(Joint::kNeck, Rad{0}, RadPerSec{12}, NewtonMeter{2.5}).commands);
  const auto alone = [&](double load) {
    writer.noteLoad(Joint::kNeck, load);
    bool seen = false;
    for (int i = 0; i < 40; ++i) {
      asked.drive(Joint::kNeck, Rad{0}, RadPerSec{12}, NewtonMeter{2 + 0.01 * (i % 7)});
      (void)writer.encode(asked.commands);
      (void)writer.takeSecond();
      seen |= writer.limitsWentAlone();
    }
    return seen;
  };
  EXPECT_FALSE(alone(0.4)) << "1 of 2.5 N m, although 0.4 is near the fraction 426 / 1023 in its register";
  EXPECT_TRUE(alone(0.9));
}

}  // namespace
}  // namespace darwinop::cm730
