// Limits of naming: what looks the same, what is normal, and more than one fault.
#include "hal/cm730/diagnosis/fault_naming.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/conversions.hpp"
#include "hal/cm730/diagnosis/drawn_robot.hpp"

namespace darwinop::cm730 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

RobotDraw inStartPose() {
  RobotDraw drawn;
  drawn.board.servo_power = true;
  for (std::size_t i = 0; i < kJoints; ++i) drawn.position_rad[i] = radFromTicks(kJointTable[i].start).value;
  return drawn;
}
hil::ServoOptions& servo(RobotDraw& drawn, Joint joint) {
  return drawn.board.servo[index(joint)];
}
void exchange(RobotDraw& drawn, Joint a, Joint b) {
  servo(drawn, a).id = row(b).id;
  servo(drawn, b).id = row(a).id;
}
std::vector<BusFault> named(const DoctorResult& result) {
  std::vector<BusFault> faults;
  for (const NamedFault& fault : result.named) faults.push_back(fault.fault);
  return faults;
}

TEST(FaultNaming, ExchangedServosWithTheSameStartAngleAreNotNamed) {
  RobotDraw drawn = inStartPose();
  exchange(drawn, Joint::kPelvYR, Joint::kPelvYL);
  EXPECT_THAT(named(examine(drawn, 1)), IsEmpty());
}

TEST(FaultNaming, ExchangedServosAreNamedInAnyPoseThatOnlyTheOtherJointCanReach) {
  RobotDraw drawn = inStartPose();
  drawn.position_rad[index(Joint::kArmLowerL)] += 1;  // not in the start pose
  drawn.position_rad[index(Joint::kHead)] += 0.5;
  exchange(drawn, Joint::kLegLowerR, Joint::kLegLowerL);
  const DoctorResult result = examine(drawn, 1);
  ASSERT_THAT(named(result), ElementsAre(BusFault::kSwapped));
  EXPECT_EQ(result.named[0].other, Joint::kLegLowerL);
}

TEST(FaultNaming, ALastServoThatIsSilentIsNotABrokenChain) {
  RobotDraw drawn = inStartPose();
  servo(drawn, Joint::kFootR).missing = true;
  EXPECT_THAT(named(examine(drawn, 1)), ElementsAre(BusFault::kServoSilent));
}

TEST(FaultNaming, TwoBrokenChainsAndASilentServoAreThree) {
  RobotDraw drawn = inStartPose();
  for (const Joint joint : {Joint::kNeck, Joint::kHead, Joint::kAnkleR, Joint::kFootR, Joint::kArmUpperL})
    servo(drawn, joint).missing = true;
  const DoctorResult result = examine(drawn, 1);
  EXPECT_THAT(named(result), ElementsAre(BusFault::kChainBroken, BusFault::kChainBroken, BusFault::kServoSilent));
}

TEST(FaultNaming, AServoWithTheIdOfANewOneIsNamedBesideAnother) {
  RobotDraw drawn = inStartPose();
  servo(drawn, Joint::kNeck).status_level = 0;
  servo(drawn, Joint::kFootL) = hil::ServoOptions::factoryFresh(1);
  const DoctorResult result = examine(drawn, 1);
  ASSERT_THAT(named(result), ElementsAre(BusFault::kDuplicateId, BusFault::kStatusLevel));
  EXPECT_TRUE(result.named[0].joints[index(Joint::kShoulderR)]);
  EXPECT_EQ(result.named[0].other, Joint::kFootL);
}

TEST(FaultNaming, ASlowPortIsNamedBeforeWhatItDelays) {
  RobotDraw drawn = inStartPose();
  drawn.latency = 16ms;
  for (hil::ServoOptions& one : drawn.board.servo) one.return_delay = 250;
  EXPECT_THAT(named(examine(drawn, 1)), ElementsAre(BusFault::kLatencyTimer, BusFault::kReturnDelays));
}

TEST(FaultNaming, TheUsualLossesAreNotAFault) {
  Rng rng{1};
  for (int i = 0; i < 60; ++i) {
    RobotDraw drawn = drawHealthy(rng);
    drawn.damaged_per_byte = 1.5e-4;  // 0.24 % of the short reads
    const DoctorResult result = examine(drawn, rng.next());
    std::string text;
    for (const NamedFault& fault : result.named) text += toText(fault);
    EXPECT_THAT(named(result), IsEmpty()) << "robot " << i << ": " << text;
  }
}

/// A start of a loop sends what it did before there was an observation.
TEST(FaultNaming, OnlyTheDoctorObserves) {
  hil::BoardOptions options;
  options.servo_power = true;
  hil::VirtualRobot robot{options};
  hil::MemoryLine line{robot};
  EXPECT_FALSE(measure(line, ProbeOptions::quick()).observed.done);
  const auto frames = line.counters().frames;
  EXPECT_TRUE(measure(line, ProbeOptions::thorough()).observed.done);
  EXPECT_GT(line.counters().frames, 5 * frames);
}

TEST(FaultNaming, AnAbsentServoIsNotSilent) {
  RobotDraw drawn = inStartPose();
  servo(drawn, Joint::kNeck).missing = servo(drawn, Joint::kHead).missing = true;
  hil::VirtualRobot robot{drawn.board};
  hil::MemoryLine line{robot};
  ProbeOptions options = ProbeOptions::thorough();
  options.absent.set(index(Joint::kNeck)).set(index(Joint::kHead));
  const ProbeReport report = probe(line, options);
  EXPECT_THAT(nameFaults(report.facts, report.findings), IsEmpty());
}

}  // namespace
}  // namespace darwinop::cm730
