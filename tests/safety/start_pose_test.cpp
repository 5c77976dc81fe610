// The start pose check.
#include "safety/start_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace darwinop::safety {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Sensors sitting() {
  Sensors seen;
  for (std::size_t i = 0; i < kJoints; ++i) {
    seen.joint[i].motion.received();
    seen.joint[i].position = radFromTicks(kJointTable[i].start);
  }
  seen.board.motion.received();
  seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
  return seen;
}

void move(Sensors& seen, Joint joint, int ticks) {
  seen.joint[index(joint)].position = radFromTicks(row(joint).start + ticks);
}

TEST(StartPose, ASittingRobotIsSecure) {
  const StartPoseCheck check = checkStartPose(sitting());
  EXPECT_TRUE(check.secure()) << describe(check);
}

TEST(StartPose, EachLegJointMayBe230TicksOffAndNoMore) {
  for (std::size_t i = 0; i < kJoints; ++i)
    for (const int ticks : {-231, -230, 230, 231}) {
      const auto joint = static_cast<Joint>(i);
      Sensors seen = sitting();
      move(seen, joint, ticks);
      EXPECT_EQ(checkStartPose(seen).secure(), !isLeg(joint) || std::abs(ticks) == 230) << row(joint).name << ticks;
    }
}

TEST(StartPose, TheReportNamesEveryJointThatIsOffAndByHowMuch) {
  Sensors seen = sitting();
  move(seen, Joint::kPelvR, 300);
  move(seen, Joint::kFootL, -400);
  const StartPoseCheck check = checkStartPose(seen);
  ASSERT_EQ(check.off_count, 2u);
  EXPECT_EQ(check.off[0].joint, Joint::kPelvR);
  EXPECT_NEAR(check.off[0].off_rad, 300 * kRadPerTick, 1e-9);
  EXPECT_EQ(check.off[1].joint, Joint::kFootL);
  EXPECT_THAT(describe(check),
              AllOf(HasSubstr("PelvR (id 9, right hip roll): +26.4 deg (+0.460 rad)"),
                    HasSubstr("FootL (id 18, left ankle roll): -35.2 deg"), Not(HasSubstr(kNotUpright))));
}

TEST(StartPose, AReadingThatIsMissingOrOldIsNotKnownAndFails) {
  Sensors seen = sitting();
  seen.joint[index(Joint::kAnkleR)].motion = {};
  seen.joint[index(Joint::kAnkleL)].motion.age = 6;
  const StartPoseCheck check = checkStartPose(seen);
  ASSERT_EQ(check.off_count, 2u);
  EXPECT_FALSE(check.off[0].position.known());
  EXPECT_THAT(describe(check), HasSubstr(std::string{"AnkleR (id 15, right ankle pitch): "} + kPositionUnknown));
}

TEST(StartPose, EachAxisOfAccelerationMayBeAQuarterOfGOff) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int counts : {-33, -32, 32, 33}) {
      Sensors seen = sitting();
      seen.board.accelerometer[axis].value += counts / 128.0 * 9.80665;
      EXPECT_EQ(checkStartPose(seen).secure(), std::abs(counts) == 32) << axis << " " << counts;
    }
}

TEST(StartPose, AnUnknownOrientationFailsAndSaysSo) {
  Sensors seen = sitting();
  seen.board.motion = {};
  const StartPoseCheck check = checkStartPose(seen);
  EXPECT_FALSE(check.secure());
  EXPECT_THAT(describe(check), HasSubstr(kOrientationUnknown));
}

TEST(StartPose, WithoutABoardTheLegsAloneDecideAndTheOrientationIsReportedAsNotKnown) {
  Sensors seen = sitting();
  seen.board = {};
  seen.board.absent = true;
  EXPECT_TRUE(checkStartPose(seen).secure());
  EXPECT_THAT(describe(checkStartPose(seen)), HasSubstr(kOrientationUnknown));
  move(seen, Joint::kPelvR, 300);
  EXPECT_FALSE(checkStartPose(seen).secure());
}

TEST(StartPose, ALyingRobotIsReportedAsSuch) {
  Sensors seen = sitting();
  seen.board.accelerometer = {MeterPerSec2{9.8}, MeterPerSec2{0}, MeterPerSec2{0.1}};
  EXPECT_THAT(describe(checkStartPose(seen)), AllOf(HasSubstr(kNotUpright), HasSubstr(" 9.80 0.00 0.10 ")));
}

TEST(StartPose, NarrowedLimitsHoldForTheStartPoseToo) {
  Config config;
  config.set("Limits", "LegLowerR", "0, 1.5");
  EXPECT_EQ(startPose(config)[index(Joint::kLegLowerR)], Rad{1.5});
}

/// Safety moves the robot no further, and with the table's pose it would never count as seated.
TEST(StartPose, IsWithinTheLimitsOfTheRobot) {
  Config config;
  config.range[index(Joint::kLegLowerR)].high = Rad{1.7};  // 2.25 rad in the table
  const auto pose = startPose(config);
  Sensors seen = sitting();
  seen.joint[index(Joint::kLegLowerR)].position = Rad{1.7};
  EXPECT_FALSE(checkStartPose(seen).secure());
  EXPECT_TRUE(checkStartPose(seen, pose).secure());
}

}  // namespace
}  // namespace darwinop::safety
