// Horn offsets on the wire: goals, positions, and the joint table's range.
#include "hal/cm730/joint_offsets.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "core/conversions.hpp"
#include "hal/cm730/bus.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "support/hex.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Nanos kCycle{16'000'000};

JointOffsets with(Joint joint, Rad offset) {
  JointOffsets offsets;
  offsets.set(joint, offset);
  return offsets;
}

/// The single goal in a writer's first frame: ff ff fe len 83 1c 08 id gain 0 goal goal ...
int goalOnTheWire(GoalWriter& writer, Joint joint, Rad goal) {
  const auto frame = writer.encode(SafeCommandsForTests{}.drive(joint, goal).commands);
  return wordAt(frame, 10);
}

/// The decoder's result for a servo at `ticks`.
Rad angleRead(const JointOffsets& offsets, Joint joint, int ticks) {
  const std::array<ReadList::Entry, 1> list{{{static_cast<std::uint8_t>(index(joint)), false}}};
  BusReadings readings;
  ReplyDecoder decoder{offsets};
  decoder.begin(list, 30, readings);
  decoder.take(Frame{kBoardId, 0, std::array<std::uint8_t, 30>{}});
  const auto word = static_cast<std::uint16_t>(ticks);
  decoder.take(Frame{row(joint).id, 0, std::array<std::uint8_t, 6>{lowByte(word), highByte(word)}});
  return readings.servo[index(joint)].position;
}

rc::Gen<double> angle(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1'000'001), [=](int part) { return low + (high - low) * part * 1e-6; });
}

struct Case {
  Joint joint{};
  JointOffsets offsets;
};
Case anyCase() {
  const auto joint = static_cast<Joint>(*rc::gen::inRange<std::size_t>(0, kJoints));
  return {joint, with(joint, Rad{*angle(-0.2, 0.2)})};
}

TEST(JointOffsets, AnOffsetOfTenTicksShiftsTheFrameOf2013) {
  GoalWriter writer{with(Joint::kNeck, Rad{10 * kRadPerTick})};
  SafeCommandsForTests asked;
  asked.drive(Joint::kNeck, radFromTicks(2040), RadPerSec{1023 * kRadPerSecPerCount});
  EXPECT_EQ(toHex(writer.encode(asked.commands)), "ff ff fe 0d 83 1c 08 13 20 00 02 08 ff 03 ff 03 0c");
}

RC_GTEST_PROP(JointOffsets, WhatIsReadBackIsWhatWasCommandedWithinATick, ()) {
  const Case c = anyCase();
  const Rad goal{*angle(c.offsets.low(c.joint).value, c.offsets.high(c.joint).value)};
  GoalWriter writer{c.offsets};
  const Rad back = angleRead(c.offsets, c.joint, goalOnTheWire(writer, c.joint, goal));
  RC_ASSERT(std::abs(back.value - goal.value) <= kRadPerTick / 2 + 1e-9);
  RC_ASSERT(writer.clamped() == 0U);
}

RC_GTEST_PROP(JointOffsets, NoGoalLeavesTheRangeOfTheJointTableOnTheWire, ()) {
  const Case c = anyCase();
  const Rad goal{*angle(-4, 4)};
  GoalWriter writer{c.offsets};
  const int ticks = goalOnTheWire(writer, c.joint, goal);
  RC_ASSERT(ticks >= row(c.joint).low && ticks <= row(c.joint).high);
  const bool reachable = goal >= c.offsets.low(c.joint) && goal <= c.offsets.high(c.joint);
  if (reachable) RC_ASSERT(writer.clamped() == 0U);
  if (goal.value < c.offsets.low(c.joint).value - 2 * kRadPerTick ||
      goal.value > c.offsets.high(c.joint).value + 2 * kRadPerTick) {
    // Within the table but outside this servo's range: the limit at the wire must act.
    const int wanted = c.offsets.servoTicks(c.joint, goal);
    RC_ASSERT(writer.clamped() == (wanted < row(c.joint).low || wanted > row(c.joint).high ? 1U : 0U));
  }
}

RC_GTEST_PROP(JointOffsets, APositionThatIsGivenBackAsAGoalIsTheSameTick, ()) {
  const Case c = anyCase();
  const int ticks = *rc::gen::inRange<int>(row(c.joint).low, row(c.joint).high + 1);
  const Rad angle_read = angleRead(c.offsets, c.joint, ticks);
  if (angle_read < radFromTicks(0) || angle_read > radFromTicks(kTickMax)) return;  // outside the range of goals
  GoalWriter writer{c.offsets};
  RC_ASSERT(goalOnTheWire(writer, c.joint, angle_read) == ticks);
}

struct OffsetRobot : ::testing::Test {
  static hil::BoardOptions powered() {
    hil::BoardOptions options;
    options.servo_power = true;
    return options;
  }
  hil::VirtualRobot robot{powered()};
  hil::MemoryLine line{robot};
  JointOffsets offsets = with(Joint::kNeck, Rad{100 * kRadPerTick});

  int registerOf(Joint joint, std::uint8_t address) {
    const auto& table = robot.board().servo(joint).table();
    return table.byte(address) | table.byte(static_cast<std::uint8_t>(address + 1)) << 8;
  }
};

TEST_F(OffsetRobot, TheServoIsShiftedAndTheJointReadsItsGoal) {
  Cm730Bus bus{line, BusConfig::forPeriod(kCycle, offsets)};
  const auto there =
      SafeCommandsForTests{}.drive(Joint::kNeck, radFromTicks(2300)).drive(Joint::kHead, radFromTicks(2100)).commands;
  BusReadings readings;
  for (int i = 1; i <= 150; ++i) {
    line.advanceTo(i * kCycle);
    bus.write(there);
    bus.read(readings);
  }
  EXPECT_EQ(registerOf(Joint::kNeck, servo::kGoalPosition), 2400);
  EXPECT_NEAR(registerOf(Joint::kNeck, servo::kPresentPosition), 2400, 2);
  EXPECT_NEAR(readings.servo[index(Joint::kNeck)].position.value, radFromTicks(2300).value, 2 * kRadPerTick);
  EXPECT_EQ(registerOf(Joint::kHead, servo::kGoalPosition), 2100) << "only the joint with an offset changes";
  EXPECT_EQ(readings.link.clamped_goals, 0U);
}

TEST_F(OffsetRobot, AGoalBeyondTheTableIsCounted) {
  Cm730Bus bus{line, BusConfig::forPeriod(kCycle, offsets)};
  BusReadings readings;
  bus.write(SafeCommandsForTests{}.drive(Joint::kNeck, radFromTicks(row(Joint::kNeck).high)).commands);
  bus.read(readings);
  EXPECT_EQ(registerOf(Joint::kNeck, servo::kGoalPosition), row(Joint::kNeck).high);
  EXPECT_EQ(readings.link.clamped_goals, 1U);
}

TEST_F(OffsetRobot, TheProbeReportsTheJointAngle) {
  ProbeOptions options = ProbeOptions::quick();
  const RobotFacts stock = measure(line, options);
  options.offsets = offsets;
  const RobotFacts corrected = measure(line, options);
  const auto neck = index(Joint::kNeck), head = index(Joint::kHead);
  EXPECT_NEAR(corrected.servo[neck].position.value, stock.servo[neck].position.value - 100 * kRadPerTick, 1e-9);
  EXPECT_NEAR(corrected.servo[head].position.value, stock.servo[head].position.value, 1e-9);
}

}  // namespace
}  // namespace darwinop::cm730
