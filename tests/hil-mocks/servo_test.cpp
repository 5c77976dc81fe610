// Limits, protections and torque of a virtual servo.
#include <gtest/gtest.h>

#include "bench.hpp"

namespace darwinop::hil {
namespace {

const std::string kNeckGoal2400 = withChecksum("FF FF 13 05 03 1E 60 09");

TEST(Servo, AGoalOutsideItsLimitsIsRejectedWithAngleLimit) {
  Bench bench;
  bench.send(withChecksum("FF FF 13 05 03 08 00 09"));  // upper limit 2304
  EXPECT_EQ(bench.send(kNeckGoal2400), withChecksum("FF FF 13 02 02"));
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().word(30), 2050);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), withChecksum("FF FF 13 02 02")) << "until a valid goal arrives";
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 05 03 1E 00 08")), withChecksum("FF FF 13 02 02"));
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), withChecksum("FF FF 13 02 00"));
}

TEST(Servo, OverheatSetsItsBitAndCutsTorqueUntilBothAreRestored) {
  Bench bench;
  bench.send(kNeckGoal2400);
  const ControlTable& neck = bench.board.servo(Joint::kNeck).table();
  EXPECT_EQ(neck.byte(24), 1);
  bench.board.setTemperature(Joint::kNeck, 85);
  bench.board.advance(bench.board.now() + 10ms);
  EXPECT_EQ(neck.word(34), 0);
  EXPECT_EQ(neck.byte(24), 0);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), withChecksum("FF FF 13 02 04"));

  bench.send(withChecksum("FF FF 13 05 03 22 FF 03"));
  EXPECT_EQ(neck.word(34), 0) << "trips again while it is hot";
  bench.board.setTemperature(Joint::kNeck, 40);
  bench.send(withChecksum("FF FF 13 05 03 22 FF 03"));
  EXPECT_EQ(neck.word(34), 1023);
  EXPECT_EQ(neck.byte(24), 0) << "torque must be enabled again";
}

TEST(Servo, LowSupplyIsReportedWithoutCuttingTorque) {
  Bench bench;
  bench.send(kNeckGoal2400);
  bench.board.setSupply(5.5);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 02 2A 01")), withChecksum("FF FF 13 03 01 37"));
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().byte(24), 1);
  EXPECT_EQ(bench.send(withChecksum("FF FF C8 04 02 32 01")), withChecksum("FF FF C8 03 00 37"));
}

TEST(Servo, InjectedErrorBitsAreInEveryStatus) {
  Bench bench;
  bench.board.setServoErrors(Joint::kNeck, error_bit::kOverload);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), withChecksum("FF FF 13 02 20"));
  EXPECT_EQ(bench.board.servo(Joint::kNeck).table().word(34), 0) << "overload is in the shutdown mask";
}

TEST(Servo, LockedEepromIsUnlockedByAPowerCycleOnly) {
  Bench bench;
  const std::string ok = withChecksum("FF FF 13 02 00"), range = withChecksum("FF FF 13 02 08");
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 03 2F 01")), ok);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 03 2F 00")), ok);
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 03 05 00")), range);
  bench.send("FF FF C8 04 03 18 00 18");
  bench.send("FF FF C8 04 03 18 01 17");
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 03 05 00")), ok);
}

TEST(Servo, UnderTorqueItIgnoresWritesToItsEeprom) {
  Bench bench;
  bench.send(withChecksum("FF FF 13 04 03 18 01"));                                             // torque on
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 03 05 FA")), withChecksum("FF FF 13 02 08"));  // return delay: range
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 02 05 01")), withChecksum("FF FF 13 03 00 00"));
  bench.send(withChecksum("FF FF 13 04 03 18 00"));
  bench.send(withChecksum("FF FF 13 04 03 05 FA"));
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 04 02 05 01")), withChecksum("FF FF 13 03 00 FA"));
}

TEST(Servo, UnpluggedOneComesBackLimpWithPowerUpValues) {
  Bench bench;
  bench.send(kNeckGoal2400);
  bench.board.advance(2s);
  bench.board.setServoDead(Joint::kNeck, true);
  bench.board.advance(3s);
  bench.board.setServoDead(Joint::kNeck, false);
  const ControlTable& neck = bench.board.servo(Joint::kNeck).table();
  EXPECT_EQ(neck.byte(24), 0);
  EXPECT_NEAR(neck.word(30), 2400, 1) << "the goal is the position at power-off";
}

TEST(Servo, AFactoryFreshOneIsUnreachableAtOneMegabaud) {
  BoardOptions options = Bench::powered();
  options.servo[18] = ServoOptions::factoryFresh();
  options.servo[19].missing = true;
  options.servo[17].firmware = 25;
  Bench bench{options};
  EXPECT_EQ(bench.send(withChecksum("FF FF 13 02 01")), "");
  EXPECT_EQ(bench.send(withChecksum("FF FF 14 02 01")), "");
  EXPECT_EQ(bench.send("FF FF 01 02 01 FB"), "FF FF 01 02 00 FC") << "its id 1 does not interfere";
  EXPECT_EQ(bench.send(withChecksum("FF FF 12 04 02 02 01")), withChecksum("FF FF 12 03 00 19"));
}

}  // namespace
}  // namespace darwinop::hil
