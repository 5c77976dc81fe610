// The cycle's SyncWrite, byte for byte.
#include "hal/cm730/goal_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/conversions.hpp"
#include "support/hex.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

TEST(GoalWriter, NeckAloneIsTheFrameOf2013) {
  GoalWriter writer;
  SafeCommandsForTests asked;
  asked.drive(Joint::kNeck, radFromTicks(2050), RadPerSec{1023 * kRadPerSecPerCount});
  EXPECT_EQ(toHex(writer.encode(asked.commands)), "ff ff fe 0d 83 1c 08 13 20 00 02 08 ff 03 ff 03 0c");
}

// Bytes of a SyncWrite to twenty servos: address, length, and an id before each servo's data.
constexpr std::size_t bytes(std::size_t registers) {
  return kFrameOverhead + 2 + kJoints * (1 + registers);
}
constexpr std::size_t kGoals = bytes(2), kSettings = bytes(6), kAll = bytes(8);
static_assert(kGoals == 68 && kSettings == 148 && kAll == 188, "docs/performance.md");

/// A writer whose servos have all they need, and which has just repeated their settings.
struct DrivingWriter : ::testing::Test {
  GoalWriter writer;
  SafeCommandsForTests asked = SafeCommandsForTests{}.driveAll(Rad{0});

  DrivingWriter() {
    for (int i = 0; i < 3 * GoalWriter::kTorqueEvery; ++i) (void)write();
    while (write() != kSettings) {
    }
  }
  std::size_t write() { return writer.encode(asked.commands).size(); }
};

TEST(GoalWriter, AnAddedServoGetsSettingsAndTorqueLimitTwiceAndThenGoalsOnly) {
  GoalWriter writer;
  const SafeCommandsForTests all = SafeCommandsForTests{}.driveAll(Rad{0});
  EXPECT_EQ(writer.encode(all.commands).size(), kAll);
  EXPECT_EQ(writer.encode(all.commands).size(), kAll) << "the first one may be lost";
  EXPECT_EQ(writer.encode(all.commands).size(), kGoals);
}

TEST_F(DrivingWriter, SendsAChangedSpeedTwiceWithoutTheTorqueLimit) {
  asked.drive(Joint::kHead, Rad{0}, RadPerSec{3});
  EXPECT_EQ(write(), kSettings);
  EXPECT_EQ(write(), kSettings);
  EXPECT_EQ(write(), kGoals);
}

TEST_F(DrivingWriter, RepeatsSettingsPeriodicallyButNotTheTorqueLimit) {
  int settings = 0;
  for (int i = 0; i < 10 * GoalWriter::kSettingsEvery; ++i) {
    const std::size_t size = write();
    ASSERT_NE(size, kAll) << "it would undo a shutdown";
    settings += size == kSettings ? 1 : 0;
  }
  EXPECT_EQ(settings, 10);
}

TEST_F(DrivingWriter, WritesATorqueLimitThatChangesInEveryStepWhileNoServoWorksAtItsLimit) {
  for (int i = 0; i < 100; ++i) {
    asked.drive(Joint::kHead, Rad{0}, RadPerSec{12.2}, NewtonMeter{1 + 0.01 * (i % 7)});
    ASSERT_EQ(write(), kAll);
    writer.noteLoad(Joint::kHead, 0.2);
    writer.noteLoad(Joint::kNeck, -0.6);
  }
}

/// The same, long after its servos have entered; the neck works at its torque limit.
struct StrainingWriter : DrivingWriter {
  StrainingWriter() {
    for (int i = 0; i < 3 * GoalWriter::kSettingsEvery; ++i) (void)write();
    while (write() != kSettings) {
    }
    writer.noteLoad(Joint::kNeck, -0.9);
  }
};

constexpr std::size_t frameTo(std::size_t servos, std::size_t registers) {
  return kFrameOverhead + 2 + servos * (1 + registers);
}

TEST_F(StrainingWriter, SendsItsTorqueLimitWithoutAGoalSoThatAShutdownIsSeen) {
  int since = GoalWriter::kTorqueEvery, writes = 0;
  for (int i = 0; i < 160; ++i, ++since) {
    asked.drive(Joint::kNeck, Rad{0}, RadPerSec{12.2}, NewtonMeter{1 + 0.01 * (i % 7)});
    const std::size_t size = write();
    ASSERT_NE(size, kAll);
    const std::size_t second = writer.takeSecond().size();
    if (!writer.limitsWentAlone()) continue;
    EXPECT_EQ(size, frameTo(1, 2));
    EXPECT_EQ(writer.limitsAlone(), SafeCommands::Mask{}.set(index(Joint::kNeck)));
    EXPECT_TRUE(second == frameTo(kJoints - 1, 2) || second == frameTo(kJoints - 1, 6)) << "the others get their goals";
    ASSERT_GE(since, GoalWriter::kTorqueEvery);
    since = 0;
    ++writes;
  }
  EXPECT_GE(writes, 160 / (2 * GoalWriter::kTorqueEvery));
}

TEST_F(StrainingWriter, SendsLimitsAloneToFourServosAtMostThatWorkAtTheirLimitsAndToAllInTurn) {
  SafeCommands::Mask had;
  for (std::size_t i = 0; i < kJoints; ++i) writer.noteLoad(static_cast<Joint>(i), 1);
  for (int i = 0; i < 160; ++i) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      asked.drive(static_cast<Joint>(joint), Rad{0}, RadPerSec{12.2}, NewtonMeter{1 + 0.01 * (i % 7)});
    (void)write();
    (void)writer.takeSecond();
    if (!writer.limitsWentAlone()) continue;
    ASSERT_LE(writer.limitsAlone().count(), 4u);
    had |= writer.limitsAlone();
  }
  EXPECT_TRUE(had.all()) << had;
}

TEST_F(StrainingWriter, GetsItsGoalWithoutALimitWhileAnotherJointEnters) {
  const SafeCommands others = SafeCommandsForTests{}.drive(Joint::kNeck, Rad{0}).commands;
  (void)writer.encode(others);
  (void)writer.takeSecond();
  EXPECT_EQ(write(), frameTo(kJoints - 1, 8));
  EXPECT_EQ(writer.takeSecond().size(), frameTo(1, 6));
}

TEST_F(StrainingWriter, SendsAChangedTorqueLimitTwice) {
  asked.drive(Joint::kHead, Rad{0}, RadPerSec{12.2}, NewtonMeter{2});
  int limits = 0;
  for (int i = 0; i < 5 * GoalWriter::kTorqueEvery; ++i) {
    (void)write();
    (void)writer.takeSecond();
    limits += writer.limitsWentAlone() ? 1 : 0;
  }
  EXPECT_EQ(limits, 2);
}

TEST_F(DrivingWriter, SendsAChangedTorqueLimitTwice) {
  writer.noteLoad(Joint::kNeck, 0.1);
  asked.drive(Joint::kHead, Rad{0}, RadPerSec{12.2}, NewtonMeter{1.1});
  EXPECT_EQ(write(), kAll);
  int again = 0;
  for (int i = 0; i < 5 * GoalWriter::kTorqueEvery; ++i) again += write() == kAll ? 1 : 0;
  EXPECT_EQ(again, 1);
}

TEST_F(DrivingWriter, ResetsAJointAfterACycleWithoutAGoal) {
  const SafeCommands neither = SafeCommandsForTests{}.commands;
  const SafeCommands torque = SafeCommandsForTests{}.torque(Joint::kHead, false).commands;
  const SafeCommands others = SafeCommandsForTests{}.drive(Joint::kNeck, Rad{0}).commands;
  for (const SafeCommands* between : {&neither, &torque, &others}) {
    (void)writer.encode(*between);
    EXPECT_EQ(write(), kAll);
    EXPECT_EQ(write(), kAll);
    EXPECT_EQ(write(), kGoals);
  }
}

TEST_F(DrivingWriter, OmitsAHeldJointAndKeepsItsSettings) {
  asked.hold(Joint::kHead);
  EXPECT_EQ(write(), kGoals - 3);
  asked.driveAll(Rad{0.1});
  EXPECT_EQ(write(), kGoals);
}

TEST_F(DrivingWriter, SendsNothingWhileAllAreHeld) {
  for (std::size_t i = 0; i < kJoints; ++i) asked.hold(static_cast<Joint>(i));
  EXPECT_EQ(write(), 0U);
}

TEST_F(DrivingWriter, SendsEverythingAgainAfterAReconnect) {
  writer.forget();
  EXPECT_EQ(write(), kAll);
}

TEST(GoalWriter, SwitchesTorqueOfSeveralServosInOneFrame) {
  GoalWriter writer;
  SafeCommandsForTests asked;
  asked.torque(Joint::kShoulderR, false).torque(Joint::kHead, true);
  EXPECT_EQ(toHex(writer.encode(asked.commands)), "ff ff fe 08 83 18 01 01 00 14 01 47");
}

TEST(GoalWriter, SendsNothingWithoutCommands) {
  GoalWriter writer;
  EXPECT_TRUE(writer.encode(SafeCommandsForTests{}.commands).empty());
}

}  // namespace
}  // namespace darwinop::cm730
