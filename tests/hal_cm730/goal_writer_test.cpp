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

TEST(GoalWriter, TwentyServosTake188BytesAnd68WhenOnlyGoalsChanged) {
  GoalWriter writer;
  EXPECT_EQ(writer.encode(SafeCommandsForTests{}.driveAll(Rad{0}).commands).size(), 188U);
  EXPECT_EQ(writer.encode(SafeCommandsForTests{}.driveAll(Rad{0.1}).commands).size(), 68U);
}

TEST(GoalWriter, SendsSettingsAgainWhenOneChanged) {
  GoalWriter writer;
  SafeCommandsForTests asked;
  asked.driveAll(Rad{0});
  (void)writer.encode(asked.commands);
  asked.drive(Joint::kHead, Rad{0}, RadPerSec{12.2}, NewtonMeter{1.0});
  EXPECT_EQ(writer.encode(asked.commands).size(), 188U);
  EXPECT_EQ(writer.encode(asked.commands).size(), 68U);
}

TEST(GoalWriter, RepeatsSettingsNowAndThenBecauseNobodyAcknowledgesThem) {
  GoalWriter writer;
  SafeCommandsForTests asked;
  asked.driveAll(Rad{0});
  int full = 0;
  for (int i = 0; i < 160; ++i) full += writer.encode(asked.commands).size() == 188U ? 1 : 0;
  EXPECT_EQ(full, 10);
}

TEST(GoalWriter, AJointThatWasLimpGetsItsSettingsAgain) {
  GoalWriter writer;
  (void)writer.encode(SafeCommandsForTests{}.driveAll(Rad{0}).commands);
  (void)writer.encode(SafeCommandsForTests{}.drive(Joint::kNeck, Rad{0}).commands);
  EXPECT_EQ(writer.encode(SafeCommandsForTests{}.driveAll(Rad{0}).commands).size(), 188U);
}

TEST(GoalWriter, SwitchesTorqueOfSeveralServosInOneFrame) {
  GoalWriter writer;
  SafeCommandsForTests asked;
  asked.torque(Joint::kShoulderR, false).torque(Joint::kHead, true);
  EXPECT_EQ(toHex(writer.encode(asked.commands)), "ff ff fe 08 83 18 01 01 00 14 01 47");
}

TEST(GoalWriter, SendsNothingWhenNothingIsToBeSaid) {
  GoalWriter writer;
  EXPECT_TRUE(writer.encode(SafeCommandsForTests{}.commands).empty());
}

}  // namespace
}  // namespace darwinop::cm730
