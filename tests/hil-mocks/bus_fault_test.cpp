// Faults on the servos' bus and of their supply: what one servo receives, and what those behind it do then.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "fault_rig.hpp"
#include "hil-mocks/wire_faults.hpp"

namespace darwinop::hil {
namespace {

InjectedFault at(Joint joint, FaultKind kind, double chance = 1) {
  InjectedFault fault = faultOf(kind, 0ms, InjectedFault::kForEver);
  fault.joints.set(index(joint));
  fault.chance = chance;
  return fault;
}

// Ids 18, 19 (Neck) and 20, each with the register after the goal's.
const std::string kThree = withChecksum("FF FF FE 0C 92 00 01 12 03 01 13 03 01 14 03");

TEST(Noise, AServoThatMissesTheRequestSilencesThoseBehindIt) {
  Robot robot;
  const std::string all = robot.send(kThree);
  robot.faults().add(at(Joint::kNeck, FaultKind::kNoise));
  robot.advance(robot.now() + 1ms);
  EXPECT_EQ(robot.send(kThree), all.substr(0, all.find(" | ")));
}

TEST(Noise, ADamagedAnswerReachesThePcAndSilencesThoseBehindIt) {
  Robot robot;
  const std::string all = robot.send(kThree);
  robot.faults().add(at(Joint::kNeck, FaultKind::kNoise, 0.5));
  robot.advance(robot.now() + 1ms);
  int damaged = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string seen = robot.send(kThree);
    const auto answers = std::ranges::count(seen, '|') + 1;
    damaged += answers == 2 ? 1 : 0;
    EXPECT_LE(std::ranges::count(seen, ' '), std::ranges::count(all, ' '));
  }
  EXPECT_NEAR(damaged, 50, 25) << "half of the requests reach it, and half of its answers are damaged";
}

TEST(Noise, AGoalForAllMissesOneServoOnly) {
  Robot robot;
  robot.faults().add(at(Joint::kNeck, FaultKind::kNoise));
  robot.advance(1ms);
  robot.send(withChecksum("FF FF FE 0A 83 1E 02 13 00 09 14 00 09"));
  EXPECT_NE(robot.board().servo(Joint::kNeck).state().goal, 0x900);
  EXPECT_EQ(robot.board().servo(Joint::kHead).state().goal, 0x900);
}

TEST(Twins, GarbleASingleAnswerToo) {
  Robot robot;
  const std::string alone = robot.readServo("13", "24");
  robot.faults().add(at(Joint::kNeck, FaultKind::kTwins));
  robot.advance(robot.now() + 1ms);
  EXPECT_NE(robot.readServo("13", "24"), alone);
}

TEST(Supply, ServosAreOffWhileItIsTooLowAndReturnWithPowerUpValues) {
  Robot robot;
  const auto neck = [&] { return robot.board().servo(Joint::kNeck).state(); };
  robot.send(withChecksum("FF FF 13 04 03 18 01"));     // torque on
  robot.send(withChecksum("FF FF 13 05 03 20 40 00"));  // moving speed
  ASSERT_TRUE(neck().pulls());
  InjectedFault low = faultOf(FaultKind::kVoltage, robot.now(), 500ms);
  low.amount = 4;
  robot.faults().add(low);
  robot.advance(robot.now() + 100ms);
  EXPECT_FALSE(neck().powered);
  EXPECT_EQ(robot.send(kNeckPing), "");
  robot.advance(robot.now() + 500ms);
  EXPECT_NE(robot.send(kNeckPing), "");
  EXPECT_FALSE(neck().torque_enable);
  EXPECT_EQ(neck().speed, 0) << "no limit, as after power-up";
}

TEST(Faults, ABootTimeIsThatOfOneStart) {
  Robot robot;
  robot.faults().add(neckWithoutSupply());
  robot.faults().add(faultOf(FaultKind::kReset, 300ms, 0ms));
  robot.advance(310ms);
  robot.send("FF FF C8 04 03 18 01 17");  // servo power on
  EXPECT_NE(robot.send(kNeckPing), "");
}

TEST(Faults, ClearForgetsMissesToCome) {
  Robot robot;
  InjectedFault miss = faultOf(FaultKind::kMiss, 0ms, 0ms);
  miss.amount = 1000;
  robot.faults().add(miss);
  robot.advance(1ms);
  robot.faults().clear();
  EXPECT_NE(robot.send(kThree), "");
}

TEST(ErrorBits, OfADamagedStatusDoNotRepairItsChecksum) {
  Rng random{1};
  Chunk chunk;
  const auto frame = bytesOf("FF FF 13 03 00 55 00");  // its checksum is wrong
  chunk.size = frame.size();
  std::ranges::copy(frame, chunk.data.begin());
  InjectedFault errors = at(Joint::kNeck, FaultKind::kErrors, 0.9999);
  errors.bits = error_bit::kOverload;
  flicker(chunk, errors, random);
  EXPECT_EQ(hexOf(chunk.bytes()), "FF FF 13 03 00 55 00");
}

}  // namespace
}  // namespace darwinop::hil
