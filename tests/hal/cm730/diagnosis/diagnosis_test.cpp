// Findings derived from measurements.
#include "hal/cm730/diagnosis/diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hal/cm730/diagnosis/chains.hpp"
#include "hal/cm730/diagnosis/cycle_time.hpp"
#include "hal/cm730/diagnosis/rows.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

RobotFacts healthy() {
  RobotFacts facts;
  facts.port = "/dev/ttyUSB0";
  facts.board = {.found = true,
                 .garbled = false,
                 .readable = true,
                 .model = 0x7300,
                 .firmware = 0x13,
                 .power_was_on = true,
                 .power_on = true,
                 .voltage = Volt{12.0},
                 .accelerometer = {}};
  for (ServoFacts& servo : facts.servo) {
    servo.found = servo.readable = true;
    servo.model = 29;
    servo.firmware = 36;
    servo.status_level = 2;
    servo.max_torque = servo.torque_limit = 1023;
    servo.voltage = Volt{11.8};
    servo.temperature = Celsius{30};
    servo.position = Rad{0};
    servo.reads = 3;
  }
  facts.round_trip.median = 1200us;
  facts.round_trip.reads = 9;
  return facts;
}

TEST(Diagnosis, OneLossIsAcceptedTwoInSixtyAreReported) {
  RobotFacts facts = healthy();
  facts.servo[4].losses = 1;
  EXPECT_EQ(worst(diagnose(facts)), Level::kOk);
  facts.servo[4].losses = 2;
  const Finding lossy = rowOf(diagnose(facts), Kind::kRepliesLost);
  EXPECT_EQ(lossy.level, Level::kWarning);
  EXPECT_THAT(lossy.what, HasSubstr("2 of 60 "));
  EXPECT_THAT(lossy.remedy, HasSubstr(servoName(Joint::kArmLowerR)));
  facts.servo[6].losses = 3;
  facts.servo[4].losses = 3;
  facts.servo[5].losses = 1;
  EXPECT_TRUE(has(diagnose(facts), Kind::kRepliesLost));
}

TEST(Diagnosis, TheLatencySignatureBeginsAtEightMilliseconds) {
  RobotFacts facts = healthy();
  facts.round_trip.median = 7999us;
  EXPECT_FALSE(has(diagnose(facts), Kind::kRoundTripLong));
  facts.round_trip.median = 8ms;
  EXPECT_TRUE(has(diagnose(facts), Kind::kRoundTripLong));
  EXPECT_EQ(worst(diagnose(facts)), Level::kError) << "longer than the loop's reply timeout";
}

TEST(Diagnosis, ACycleIsBytesDelaysAndUsb) {
  RobotFacts facts = healthy();
  facts.round_trip.median = 160us;  // wire time only
  // 188 + 70 + 36 + 19 x 12 + 26 bytes
  EXPECT_EQ(cycleTime(facts), 5480us);
  facts.servo[0].return_delay = 250;
  EXPECT_EQ(cycleTime(facts), 5980us);
  facts.round_trip.median = 1160us;
  EXPECT_EQ(cycleTime(facts), 6980us);
}

TEST(Diagnosis, APeriodMustFitAFullWriteAndLeaveAMillisecondWithGoalsOnly) {
  RobotFacts facts = healthy();
  facts.period = 8ms;
  facts.round_trip.median = 160us + 2500us;  // as much as the bus waits for a reply at 8 ms
  EXPECT_TRUE(cycleFits(facts)) << "5.48 + 2.5 ms, and 4.28 + 2.5 ms";
  facts.round_trip.median += 1us;
  EXPECT_FALSE(cycleFits(facts));
  facts.round_trip.median = 160us;
  for (ServoFacts& servo : facts.servo) servo.return_delay = 63;  // 2.52 ms together
  EXPECT_TRUE(cycleFits(facts));
  for (ServoFacts& servo : facts.servo) servo.return_delay = 64;  // 2.56 ms
  EXPECT_FALSE(cycleFits(facts));
  EXPECT_TRUE(has(diagnose(facts), Kind::kCycleTooLong));
  facts.period = 16ms;
  EXPECT_TRUE(cycleFits(facts));
}

TEST(Diagnosis, AnUnsupportedModelOrWheelModeCannotBeDriven) {
  RobotFacts facts = healthy();
  facts.servo[2].model = 12;
  facts.servo[3].cw_limit = facts.servo[3].ccw_limit = 0;
  const Findings rows = diagnose(facts);
  EXPECT_TRUE(rowOf(rows, Joint::kArmUpperR).is(Kind::kServoModel));
  EXPECT_THAT(rowOf(rows, Joint::kArmUpperR).what, HasSubstr(" 12 "));
  EXPECT_TRUE(rowOf(rows, Joint::kArmUpperL).is(Kind::kWheelMode));
  EXPECT_EQ(worst(rows), Level::kError);
}

TEST(Diagnosis, ServosUnderTorqueWithoutALoopAreOneWarning) {
  RobotFacts facts = healthy();
  EXPECT_TRUE(underTorqueRows(facts).empty());
  for (ServoFacts& servo : facts.servo) servo.torque_on = true;
  const Findings rows = underTorqueRows(facts);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].level, Level::kWarning);
  EXPECT_THAT(rows[0].what, testing::StartsWith("20 "));
  EXPECT_THAT(rows[0].remedy, HasSubstr("RESET"));
  facts.board.absent = true;
  EXPECT_THAT(underTorqueRows(facts)[0].remedy, testing::Not(HasSubstr("RESET")));
}

TEST(Diagnosis, ATorqueLimitOfZeroIsAShutdown) {
  RobotFacts facts = healthy();
  facts.servo[2].torque_limit = 0;
  EXPECT_TRUE(rowOf(diagnose(facts), Joint::kArmUpperR).is(Kind::kTorqueLimitZero));
  facts.servo[2].max_torque = 0;
  EXPECT_TRUE(rowOf(diagnose(facts), Joint::kArmUpperR).is(Kind::kMaxTorqueZero)) << "a setting, not a shutdown";
}

TEST(Diagnosis, MissingServoPowerHidesTheServos) {
  RobotFacts facts = healthy();
  facts.board.power_on = false;
  const Findings rows = diagnose(facts);
  EXPECT_EQ(rowOf(rows, Kind::kServoPowerOff).level, Level::kError);
  EXPECT_TRUE(std::ranges::none_of(rows, [](const Finding& row) { return row.joint.has_value(); }));
}

TEST(Diagnosis, InvalidRepliesSuggestAWrongPort) {
  RobotFacts facts;
  facts.port = "/dev/ttyUSB0";
  facts.board.garbled = true;
  EXPECT_THAT(rowOf(diagnose(facts), Kind::kBoardGarbled).what, HasSubstr("/dev/ttyUSB0"));
}

TEST(Diagnosis, EveryFindingHasARemedyOrRefersToAnotherRow) {
  RobotFacts facts = healthy();
  for (std::size_t i = 0; i < kJoints; ++i) {
    facts.servo[i].error_bits = static_cast<std::uint8_t>(1u << (i % 7));
    facts.servo[i].found = facts.servo[i].readable = i % 3 != 0;
  }
  const Joint behind_a_break = Joint::kFootR;
  for (const Joint joint : {Joint::kLegLowerR, Joint::kAnkleR, behind_a_break})
    facts.servo[index(joint)].found = facts.servo[index(joint)].readable = false;
  facts.board.voltage = Volt{9.0};
  facts.round_trip.median = 17ms;
  const Findings rows = diagnose(facts);
  EXPECT_THAT(rowOf(rows, behind_a_break).what, HasSubstr(servoName(Joint::kLegLowerR)));
  for (const Finding& row : rows) {
    const bool another_row_does = row.joint == behind_a_break || row.joint == Joint::kAnkleR;
    EXPECT_TRUE(row.level == Level::kOk || another_row_does || !row.remedy.empty()) << row.what;
  }
}

TEST(Chains, EveryBreakIsLocated) {
  for (std::size_t broken = 0; broken < kJoints; ++broken) {
    const Joint first = static_cast<Joint>(broken);
    RobotFacts facts = healthy();
    for (std::size_t i = broken; i < kJoints; ++i)
      if (kJointTable[i].chain == row(first).chain) facts.servo[i].found = false;
    const ChainBreak found = findBreak(facts, row(first).chain);
    ASSERT_TRUE(found.first_silent);
    EXPECT_EQ(*found.first_silent, first);
    // Legs and arms count up by two along a chain, the head by one; 1, 2, 7, 8 and 19 are connected to the board.
    const int id = row(first).id;
    const bool on_the_board = id == 1 || id == 2 || id == 7 || id == 8 || id == 19;
    EXPECT_EQ(found.last_answering.has_value(), !on_the_board) << id;
    if (found.last_answering) {
      EXPECT_EQ(row(*found.last_answering).id, id == 20 ? 19 : id - 2);
    }
  }
}

TEST(Chains, ASilentServoInTheMiddleIsNotABreak) {
  RobotFacts facts = healthy();
  facts.servo[index(Joint::kLegUpperR)].found = facts.servo[index(Joint::kLegLowerR)].found = false;
  EXPECT_FALSE(findBreak(facts, Chain::kRightLeg).first_silent);
  EXPECT_EQ(findBreak(facts, Chain::kRightLeg).silent, 0);
}

}  // namespace
}  // namespace darwinop::cm730
