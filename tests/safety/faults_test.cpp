// Several faults at once, thresholds, hysteresis, what is not known, and how faults end.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

TEST(Faults, TheWorstReactionWins) {
  Rig rig;
  rig.start();
  rig.robot.servo[3].celsius = 66;
  rig.robot.volt = 10.5;
  rig.runFor(3);
  EXPECT_TRUE(rig.active(Fault::kBatteryLow));
  EXPECT_EQ(rig.report().worst, Fault::kServoHot);
  EXPECT_EQ(rig.report().worst_joint, 4);
  rig.robot.buttons = 1;
  rig.runFor(0.5);
  EXPECT_EQ(rig.report().worst, Fault::kReleasedByButton);
  EXPECT_EQ(rig.report().reaction, Reaction::kLimp);
  EXPECT_TRUE(rig.active(Fault::kServoHot));
}

TEST(Faults, HysteresisKeepsAFaultBetweenItsThresholds) {
  Rig rig;
  rig.start();
  rig.robot.volt = 10.8;
  rig.robot.servo[3].celsius = 66;
  rig.robot.acceleration = {9.8, 0, 0};
  rig.runFor(3);
  rig.robot.volt = 11.2;
  rig.robot.servo[3].celsius = 62;
  rig.robot.acceleration = {std::sin(50 * kRadPerDegree) * 9.8, 0, std::cos(50 * kRadPerDegree) * 9.8};
  rig.runFor(5);
  EXPECT_TRUE(rig.active(Fault::kBatteryLow));
  EXPECT_TRUE(rig.active(Fault::kServoHot));
  EXPECT_TRUE(rig.active(Fault::kFell));
}

TEST(Faults, ALatchedCauseIsGoneOnlyPastItsHysteresis) {
  Rig rig;
  rig.start();
  rig.robot.volt = 9.9;
  rig.robot.servo[3].celsius = 76;
  rig.runFor(5);
  rig.robot.volt = 10.2;
  rig.robot.servo[3].celsius = 72;
  rig.runFor(5);
  ++rig.commands.fault_resets;
  rig.cycle();
  EXPECT_TRUE(rig.active(Fault::kBatteryEmpty));
  EXPECT_TRUE(rig.active(Fault::kServoOverheat));
}

TEST(Faults, ALatchedFaultGoesOnNamingTheServoThatRaisedIt) {
  Rig rig;
  rig.start();
  rig.robot.servo[16].celsius = 76;
  rig.runFor(1);
  EXPECT_EQ(rig.report().worst_joint, 17);
  rig.robot.servo[2].celsius = 76;
  rig.runFor(1);
  EXPECT_EQ(rig.report().worst_joint, 17);
  rig.robot.servo[2].celsius = rig.robot.servo[16].celsius = 40;
  rig.runFor(2);
  EXPECT_EQ(rig.report().worst_joint, 17);
}

TEST(Faults, AmongEqualsTheFirstRowIsTheWorst) {
  Rig rig;
  rig.start();
  rig.robot.volt = 10.5;
  rig.robot.servo[2].error_bits = error_bit::kVoltage;
  rig.runFor(3);
  ASSERT_TRUE(rig.active(Fault::kServoVoltage));
  EXPECT_EQ(rig.report().worst, Fault::kBatteryLow);
}

TEST(Faults, AVoltageFaultEndsAfterASecondOfGoodSupplyAndNotBetweenTwoDips) {
  Rig rig;
  rig.start();
  rig.robot.servo[2].error_bits = error_bit::kVoltage;
  rig.runFor(1);
  ASSERT_TRUE(rig.active(Fault::kServoVoltage));
  rig.robot.servo[2].error_bits = 0;
  for (int i = 0; i < 55; ++i) {  // 0.9 s
    rig.cycle();
    ASSERT_TRUE(rig.active(Fault::kServoVoltage)) << "cycle " << i;
  }
  rig.runFor(0.5);
  EXPECT_FALSE(rig.active(Fault::kServoVoltage));
}

TEST(Faults, AServoTheBusHasGivenUpIsReportedAtOnce) {
  Rig rig;
  rig.start();
  rig.runFor(1.5);
  rig.robot.given_up.set(4);
  rig.run(2);
  EXPECT_TRUE(rig.active(Fault::kServoSilent));
  EXPECT_EQ(rig.report().worst_joint, 5);
}

TEST(Faults, ServoPowerThatGoesOffWhileTheRobotIsLimpEndsNoController) {
  Rig rig;
  rig.runFor(1);
  ASSERT_EQ(rig.state(), State::kLimp);
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.runFor(1);
  EXPECT_TRUE(rig.active(Fault::kServoPowerOff));
  EXPECT_FALSE(rig.active(Fault::kBoardReset));
  EXPECT_FALSE(rig.report().controller_must_end);
  rig.newSession();
  rig.run(3);
  EXPECT_EQ(rig.state(), State::kTakingOver) << "it waits for power";
  rig.robot.power_obeys = true;
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(Faults, AMissedStartIsOverAtTheNextStartAlsoWhenNoPersonHasActed) {
  constexpr std::size_t kServo = index(Joint::kFootR);
  Rig rig;
  rig.robot.servo[kServo].follows = false;
  rig.robot.servo[kServo].position += 0.4;
  rig.start();
  rig.run(2);
  ASSERT_TRUE(rig.active(Fault::kStartMissed));
  rig.robot.servo[kServo].follows = true;
  rig.commands.unattended = true;
  rig.newSession();
  rig.run(2);
  ASSERT_TRUE(rig.reach(State::kDriven));
  rig.run(2);
  EXPECT_FALSE(rig.active(Fault::kStartMissed));
}

TEST(Faults, ServosThatStartUpAreNotSilentYet) {
  Rig rig;
  rig.runFor(1);  // each was polled: it is limp, and losing power is not a release
  rig.robot.servo_power = rig.robot.power_obeys = false;
  rig.runFor(2);
  rig.robot.servo_power = true;
  for (FakeServo& servo : rig.robot.servo) servo.answers = false;
  rig.robot.given_up.set();
  for (int i = 0; i < 40; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.active(Fault::kServoSilent)) << i;
  }
  for (FakeServo& servo : rig.robot.servo) servo.answers = true;
  rig.robot.given_up.reset();
  rig.runFor(1);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Faults, FreeFallHasNoDirection) {
  Rig rig;
  rig.start();
  rig.robot.acceleration = {1.5, 0, 0.5};
  rig.runFor(2);
  EXPECT_FALSE(rig.active(Fault::kFell));
}

TEST(Faults, WhatIsNotKnownIsNotAFault) {
  Rig rig;
  rig.robot.volt = kUnknown;
  rig.robot.acceleration = {kUnknown, 0, 0};
  for (FakeServo& servo : rig.robot.servo) servo.celsius = kUnknown;
  rig.start();
  rig.runFor(10);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Faults, OneCorruptedTemperatureIsNotAFault) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  rig.robot.seen.joint[5].polled.received();
  rig.robot.seen.joint[5].temperature = Celsius{110};
  rig.robot.seen.joint[5].torque_enabled = true;
  rig.robot.seen.joint[5].torque_limit = NewtonMeter{2.5};
  rig.runFor(3);
  EXPECT_TRUE(rig.report().active.none());
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST(Faults, AJoltIsNotAFall) {
  Rig rig;
  rig.start();
  for (int i = 0; i < 100; ++i) {
    rig.robot.acceleration = {i % 10 == 0 ? 30.0 : 0.0, 0, i % 10 == 1 ? 0.5 : 9.8};
    rig.run(3);
  }
  EXPECT_FALSE(rig.active(Fault::kFell));
}

TEST(Faults, AFallCanBeMadeToReleaseTheJoints) {
  Config config;
  config.on_fall = OnFall::kLimp;
  Rig rig{config};
  rig.start();
  rig.robot.acceleration = {0, 9.8, 0};
  ASSERT_TRUE(rig.reach(State::kLimp));
  EXPECT_TRUE(rig.safe->torqueOff().all());
  EXPECT_EQ(rig.report().reaction, Reaction::kLimp);
  rig.robot.acceleration = {0, 0, 9.8};
  EXPECT_TRUE(rig.reach(State::kDriven)) << "stood up again by a person";
}

TEST(Faults, ThresholdsComeFromTheConfiguration) {
  Config config;
  config.set("Safety", "battery_low", "11.8");
  config.set("Safety", "hot", "40");
  config.set("Safety", "stall_ms", "100");
  Rig rig{config};
  rig.start();
  rig.robot.volt = 11.7;
  rig.robot.servo[0].celsius = 41;
  rig.runFor(3);
  EXPECT_TRUE(rig.active(Fault::kBatteryLow));
  EXPECT_TRUE(rig.active(Fault::kServoHot));
  rig.steps = false;
  EXPECT_NEAR(0.016 * rig.runUntil([&] { return rig.active(Fault::kControllerStalled); }), 0.1, 0.02);
}

TEST(Faults, ANewSessionClearsWhatIsOver) {
  Rig rig;
  rig.start();
  rig.robot.volt = 9;
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.robot.volt = 12;
  rig.runFor(3);
  EXPECT_TRUE(rig.report().controller_must_end);
  rig.newSession();
  rig.cycle();
  EXPECT_FALSE(rig.report().controller_must_end);
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(Faults, ANewSessionDoesNotDriveARobotWhoseBatteryIsStillEmpty) {
  Rig rig;
  rig.start();
  rig.robot.volt = 9;
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.newSession();
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kLimp);
    ASSERT_TRUE(rig.report().controller_must_end);
  }
}

}  // namespace
}  // namespace darwinop::safety
