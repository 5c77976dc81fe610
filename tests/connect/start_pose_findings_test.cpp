// Warnings before a robot moves to its start pose.
#include "connect/start_pose_findings.hpp"

#include <gmock/gmock.h>

#include "core/conversions.hpp"

namespace darwinop::connect {
namespace {

cm730::RobotFacts sitting() {
  cm730::RobotFacts facts;
  for (std::size_t i = 0; i < kJoints; ++i) {
    facts.servo[i].readable = true;
    facts.servo[i].position = radFromTicks(kJointTable[i].start);
  }
  facts.board.readable = true;
  facts.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
  return facts;
}

TEST(StartPoseFindings, ARobotThatSitsIsWell) {
  EXPECT_EQ(cm730::worst(startPoseFindings(sitting())), cm730::Level::kOk);
}

TEST(StartPoseFindings, ABentKneeIsNamedWithARemedy) {
  cm730::RobotFacts facts = sitting();
  facts.servo[index(Joint::kLegLowerR)].position = Rad{0};
  const cm730::Findings findings = startPoseFindings(facts);
  EXPECT_EQ(cm730::worst(findings), cm730::Level::kWarning);
  std::string text;
  for (const cm730::Finding& finding : findings) text += cm730::toText(finding);
  EXPECT_THAT(text, testing::HasSubstr("LegLowerR"));
  EXPECT_TRUE(findings.back().is(cm730::Kind::kStartPose));
  EXPECT_NE(findings.back().remedy, "");
}

TEST(StartPoseFindings, AJointThatWasNotReadIsNotTakenForWell) {
  cm730::RobotFacts facts = sitting();
  facts.servo[index(Joint::kAnkleL)].readable = false;
  EXPECT_EQ(cm730::worst(startPoseFindings(facts)), cm730::Level::kWarning);
}

}  // namespace
}  // namespace darwinop::connect
