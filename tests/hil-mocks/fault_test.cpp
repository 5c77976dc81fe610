// Faults of a virtual robot.
#include <gtest/gtest.h>

#include "fault_rig.hpp"
#include "hil-mocks/random_fault.hpp"
#include "hil-mocks/wire_faults.hpp"

namespace darwinop::hil {
namespace {

TEST(Faults, DeadServoIsSilentForItsTime) {
  Robot robot;
  InjectedFault dead = faultOf(FaultKind::kDead, 100ms, 50ms);
  dead.joints.set(index(Joint::kNeck));
  robot.faults().add(dead);
  EXPECT_NE(robot.send(kNeckPing), "");
  robot.advance(100ms);
  EXPECT_EQ(robot.send(kNeckPing), "");
  EXPECT_NE(robot.send("FF FF 01 02 01 FB"), "") << "only the neck is dead";
  robot.advance(150ms);
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(Faults, OfAScriptStartInOrderOfTime) {
  Robot robot;
  std::vector<InjectedFault> faults;
  for (const Nanos at : {30ms, 10ms, 20ms, 10ms, 40ms}) faults.push_back(faultOf(FaultKind::kReset, at, 0ms));
  robot.faults().add(faultOf(FaultKind::kReset, 15ms, 0ms));
  robot.faults().add(faults);
  for (const auto& [until, begun] : {std::pair{9ms, 0}, {10ms, 2}, {15ms, 3}, {20ms, 4}, {39ms, 5}, {40ms, 6}}) {
    robot.advance(until);
    EXPECT_EQ(robot.faults().begun(), begun) << until.count();
  }
}

// Guards against insertion in quadratic time, which took minutes.
TEST(Faults, AScriptMayHaveAHundredThousand) {
  Robot robot;
  std::vector<InjectedFault> faults;
  for (int i = 0; i < 100'000; ++i) faults.push_back(faultOf(FaultKind::kReset, 1s + Nanos{i}, 0ms));
  for (int times = 0; times < 4; ++times) robot.faults().add(faults);
  robot.advance(900ms);
  EXPECT_EQ(robot.faults().begun(), 0);
}

TEST(Faults, AServoBootsAfterASupplyLoss) {
  Robot robot;
  robot.faults().add(neckWithoutSupply());
  robot.advance(130ms);
  EXPECT_EQ(robot.send(kNeckPing), "");
  robot.advance(141ms);
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(Faults, ABlockedJointShutsItsServoDownRepeatedly) {
  Robot robot;
  const auto neck = [&] { return robot.board().servo(Joint::kNeck).state(); };
  InjectedFault jam = faultOf(FaultKind::kJam, 0ms, InjectedFault::kForEver);
  jam.joints.set(index(Joint::kNeck));
  jam.amount = 0.5;
  robot.faults().add(jam);
  for (int i = 0; i < 2; ++i) {
    robot.send(withChecksum("FF FF 13 05 03 22 FF 03"));  // torque limit
    robot.send(withChecksum("FF FF 13 04 03 18 01"));     // torque on
    robot.advance(robot.now() + 450ms);
    EXPECT_TRUE(neck().pulls());
    robot.advance(robot.now() + 100ms);
    EXPECT_FALSE(neck().pulls());
    EXPECT_EQ(neck().torque_limit, 0);
    EXPECT_EQ(robot.send(kNeckPing), "FF FF 13 02 20 CA") << "overload";
  }
}

TEST(Faults, MissedBulkReadsGetNoReply) {
  Robot robot;
  const std::string read = withChecksum("FF FF FE 06 92 00 01 C8 03");
  InjectedFault miss = faultOf(FaultKind::kMiss, 0ms, 0ms);
  miss.amount = 2;
  robot.faults().add(miss);
  robot.advance(1ms);
  EXPECT_EQ(robot.send(read), "");
  EXPECT_EQ(robot.send(read), "");
  EXPECT_NE(robot.send(read), "");
}

TEST(Faults, ABabblingServoSendsUnsolicitedBytes) {
  Robot robot;
  InjectedFault babble = faultOf(FaultKind::kBabble, 10ms, 100ms);
  babble.amount = 8;
  robot.faults().add(babble);
  robot.advance(100ms);
  EXPECT_FALSE(robot.output().empty());
}

TEST(Faults, TwoDevicesWithOneIdGarbleTheirAnswer) {
  Robot robot;
  const std::string read = withChecksum("FF FF FE 06 92 00 02 13 24");
  const std::string alone = robot.send(read);
  InjectedFault twins = faultOf(FaultKind::kTwins, 10ms, InjectedFault::kForEver);
  twins.joints.set(index(Joint::kNeck));
  robot.faults().add(twins);
  robot.advance(20ms);
  EXPECT_NE(robot.send(read), alone);
}

TEST(Faults, OverlappingFaultsEndWithTheLaterOne) {
  Robot robot;
  for (const Nanos at : {10ms, 20ms}) {
    InjectedFault dead = faultOf(FaultKind::kDead, at, 50ms);
    dead.joints.set(index(Joint::kNeck));
    robot.faults().add(dead);
  }
  robot.advance(61ms);
  EXPECT_EQ(robot.send(kNeckPing), "");
  robot.advance(70ms);
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(Faults, TemperatureRampsAndReturns) {
  Robot robot;
  InjectedFault heat = faultOf(FaultKind::kHeat, 0ms, 3s);
  heat.joints.set(index(Joint::kNeck));
  heat.amount = 70;
  heat.over = 2s;
  robot.faults().add(heat);
  robot.advance(1s);
  EXPECT_EQ(robot.readServo("13", "2B"), withChecksum("FF FF 13 03 00 32")) << "50 deg C halfway";
  robot.advance(2s);
  EXPECT_EQ(robot.readServo("13", "2B"), withChecksum("FF FF 13 03 00 46"));
  robot.advance(3s);
  EXPECT_EQ(robot.readServo("13", "2B"), withChecksum("FF FF 13 03 00 1E"));
}

TEST(Faults, OfTwoCausesOfHeatTheHotterOneCounts) {
  Robot robot;
  for (const double celsius : {85.0, 60.0}) {
    InjectedFault heat = faultOf(FaultKind::kHeat, celsius > 80 ? 0ms : 500ms, 2s);
    heat.joints.set(index(Joint::kNeck));
    heat.amount = celsius;
    robot.faults().add(heat);
  }
  robot.advance(1s);
  EXPECT_EQ(robot.readServo("13", "2B"), withChecksum("FF FF 13 03 04 55")) << "still overheated";
}

/// The bit of a shutdown is then in more than two answers.
TEST(Faults, RandomHeatLastsForMoreThanHalfASecond) {
  Rng random{1};
  for (int i = 0; i < 1000; ++i) EXPECT_GE(randomFault(FaultKind::kHeat, 0ms, random).lasts, 600ms);
}

TEST(Faults, LowVoltageShowsOnBoardAndServos) {
  Robot robot;
  InjectedFault low = faultOf(FaultKind::kVoltage, 0ms, 1s);
  low.amount = 9.9;
  robot.faults().add(low);
  EXPECT_EQ(robot.readServo("C8", "32"), withChecksum("FF FF C8 03 00 63"));
  EXPECT_EQ(robot.readServo("13", "2A"), withChecksum("FF FF 13 03 00 63"));
}

TEST(Faults, ButtonsErrorsAndFallShow) {
  Robot robot;
  InjectedFault button = faultOf(FaultKind::kButton, 0ms, 1s);
  button.bits = 1;
  robot.faults().add(button);
  InjectedFault errors = faultOf(FaultKind::kErrors, 0ms, 1s);
  errors.joints.set(index(Joint::kNeck));
  errors.bits = error_bit::kOverload;
  robot.faults().add(errors);
  InjectedFault fallen = faultOf(FaultKind::kFallen, 0ms, 1s);
  fallen.fall = Fall::kFront;
  robot.faults().add(fallen);
  EXPECT_EQ(robot.readServo("C8", "1E"), withChecksum("FF FF C8 03 00 01"));
  EXPECT_EQ(robot.send(kNeckPing), withChecksum("FF FF 13 02 20"));
  EXPECT_EQ(robot.send(withChecksum("FF FF C8 04 02 2C 06")), withChecksum("FF FF C8 08 00 00 02 80 01 00 02"))
      << "y is 384: below 512 - 80";
  robot.advance(1s);
  EXPECT_EQ(robot.readServo("C8", "1E"), withChecksum("FF FF C8 03 00 00"));
  EXPECT_EQ(robot.send(kNeckPing), withChecksum("FF FF 13 02 00"));
}

TEST(Faults, BoardResetCutsServoPower) {
  Robot robot;
  robot.faults().add(faultOf(FaultKind::kReset, 10ms, 0ms));
  EXPECT_NE(robot.send(kNeckPing), "");
  robot.advance(10ms);
  EXPECT_EQ(robot.send(kNeckPing), "");
  robot.send("FF FF C8 04 03 18 01 17");
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(Faults, StalledBoardAnswersLater) {
  Robot robot;
  robot.faults().add(faultOf(FaultKind::kStall, 10ms, 90ms));
  robot.advance(20ms);
  EXPECT_EQ(robot.send(kNeckPing, 70ms), "");
  EXPECT_EQ(robot.send("", 20ms), "FF FF 13 02 00 EA");
}

TEST(Faults, ClearEndsAllOfThem) {
  Robot robot;
  InjectedFault dead = faultOf(FaultKind::kDead, 0ms, InjectedFault::kForEver);
  dead.joints.set();
  robot.faults().add(dead);
  robot.faults().add(faultOf(FaultKind::kStall, 0ms, 10s));
  robot.faults().add(faultOf(FaultKind::kUnplug, 0ms, 10s));
  robot.advance(20ms);
  EXPECT_FALSE(robot.portOpen());
  robot.faults().clear();
  robot.advance(21ms);
  EXPECT_TRUE(robot.portOpen());
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(WireFaults, OneShotAffectsOneFrameOnly) {
  Robot robot;
  InjectedFault drop = faultOf(FaultKind::kDrop, 0ms, 0ms);
  drop.amount = 1;
  robot.faults().add(drop);
  EXPECT_EQ(robot.send(kNeckPing).size(), 5u * 3 - 1);
  EXPECT_EQ(robot.send(kNeckPing), "FF FF 13 02 00 EA");
}

TEST(WireFaults, RequestsCanBeCorrupted) {
  Robot robot;
  InjectedFault corrupt = faultOf(FaultKind::kRepeatFrame, 0ms, 1s);
  corrupt.way = Way::kRequests;
  robot.faults().add(corrupt);
  robot.advance(1ms);
  EXPECT_EQ(robot.send(kNeckPing), "FF FF 13 02 00 EA | FF FF 13 02 00 EA");
}

TEST(WireFaults, ADelayedFrameDelaysLaterOnes) {
  Robot robot;
  InjectedFault delay = faultOf(FaultKind::kDelay, 0ms, 0ms);
  delay.amount = 3;
  robot.faults().add(delay);
  robot.advance(1ms);
  robot.receive(bytesOf(kNeckPing), robot.now());
  robot.receive(bytesOf(kNeckPing), robot.now());
  robot.advance(2ms);
  ASSERT_FALSE(robot.output().empty());
  EXPECT_EQ(robot.output().front().at, 1ms + 120us + 3ms);
  robot.output().pop();
  EXPECT_EQ(robot.output().front().at, 1ms + 120us + 3ms);
}

TEST(WireFaults, ChanceMatchesItsRate) {
  Robot robot;
  InjectedFault corrupt = faultOf(FaultKind::kCorrupt, 0ms, InjectedFault::kForEver);
  corrupt.amount = 1;
  corrupt.chance = 0.25;
  robot.faults().add(corrupt);
  robot.advance(1ms);
  int spoiled = 0;
  for (int i = 0; i < 1000; ++i) spoiled += robot.send(kNeckPing, 1ms) == "FF FF 13 02 00 EA" ? 0 : 1;
  EXPECT_NEAR(spoiled, 250, 50);
}

TEST(WireFaults, EachKindChangesTheFrameAsNamed) {
  const auto frame = bytesOf("FF FF 13 02 00 EA");
  Rng random{5};
  const auto spoiled_by = [&](FaultKind kind, double amount) {
    InjectedFault fault = faultOf(kind, 0ms, 0ms);
    fault.amount = amount;
    Chunk chunk{frame, 1ms};
    spoil(chunk, fault, random);
    return chunk;
  };
  EXPECT_EQ(spoiled_by(FaultKind::kDrop, 2).size, 4u);
  EXPECT_EQ(spoiled_by(FaultKind::kDrop, 99).size, 0u);
  EXPECT_EQ(spoiled_by(FaultKind::kRepeat, 2).size, 8u);
  EXPECT_EQ(spoiled_by(FaultKind::kRepeatFrame, 0).size, 12u);
  EXPECT_EQ(spoiled_by(FaultKind::kGarbage, 9).size, 15u);
  EXPECT_EQ(spoiled_by(FaultKind::kGarbage, 100000).size, Chunk::kCapacity);
  EXPECT_EQ(spoiled_by(FaultKind::kDelay, 2.5).at, 3500us);
  EXPECT_NE(hexOf(spoiled_by(FaultKind::kCorrupt, 1).bytes()), hexOf(frame));
}

TEST(RandomFaults, OccurAtTheGivenRateAndOfTheGivenKinds) {
  Robot robot;
  InjectedFault random = faultOf(FaultKind::kRandom, 0ms, 100s);
  random.amount = 5;
  random.kinds.reset();
  random.kinds.set(static_cast<std::size_t>(FaultKind::kHeat));
  robot.faults().add(random);
  robot.advance(100s);
  EXPECT_NEAR(static_cast<double>(robot.faults().begun()), 500, 60);
  EXPECT_NE(robot.send(kNeckPing), "");
  EXPECT_TRUE(robot.portOpen());
  robot.advance(110s);
  EXPECT_EQ(robot.faults().active(), 0u) << "all have ended";
}

}  // namespace
}  // namespace darwinop::hil
