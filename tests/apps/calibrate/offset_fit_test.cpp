// Offsets from exact gravity torques: what is found, what is not, and how they get into robot.ini.
#include "apps/calibrate/joints/offset_fit.hpp"

#include <gmock/gmock.h>

#include "apps/calibrate/joints/messages.hpp"
#include "apps/calibrate/joints/offset_text.hpp"
#include "apps/calibrate/messages.hpp"
#include "apps/calibrate/twin_bench.hpp"
#include "connect/robot_file.hpp"
#include "core/servo_limits.hpp"

namespace darwinop::calibrate {
namespace {

constexpr double kHidden = 0.04;  // rad, in every joint
constexpr double kLoadSigma = 1e-5;

/// Every joint at five angles in these postures; loads 3 % greater than in the model, as at a lower supply.
std::vector<GravityPoint> exactPoints(GravityModel& gravity, std::span<const TrunkPosture* const> postures,
                                      double sigma = kLoadSigma) {
  std::vector<GravityPoint> out;
  for (const TrunkPosture* const posture : postures)
    for (std::size_t i = 0; i < kJoints; ++i)
      for (const double share : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
        const auto joint = static_cast<Joint>(i);
        JointValues truth = basePose();
        truth[i] += share * sweepOf(joint).amplitude_rad;
        const double torque = gravity.holdingTorques(truth, posture->up)[i];
        GravityPoint point{.joint = joint,
                           .angles_rad = truth,
                           .load = 1.03 * torque / kMaxTorqueNm,
                           .sigma = sigma,
                           .up = posture->up};
        for (double& angle : point.angles_rad) angle += kHidden;
        out.push_back(point);
      }
  return out;
}

struct OffsetFit : testing::Test {
  GravityModel gravity{shippedModel()};
};

TEST_F(OffsetFit, FindsTheOffsetOfEveryJointWhateverTheScaleOfItsLoad) {
  const std::vector<JointOffset> found = fitOffsets(exactPoints(gravity, sweepPostures()), gravity);
  ASSERT_EQ(found.size(), kJoints);
  for (const JointOffset& one : found) {
    EXPECT_NEAR(one.offset_rad, kHidden, 0.0005) << row(one.joint).name;
    EXPECT_TRUE(one.observed) << row(one.joint).name;
  }
}

TEST_F(OffsetFit, AJointThatTurnsAboutTheVerticalAloneIsNotObserved) {
  const std::array upright{sweepPostures().front()};
  const std::vector<JointOffset> found = fitOffsets(exactPoints(gravity, upright), gravity);
  const auto neck = std::ranges::find(found, Joint::kNeck, &JointOffset::joint);
  ASSERT_NE(neck, found.end());
  EXPECT_FALSE(neck->observed);
  const std::string text = asText(found, {});
  EXPECT_THAT(text, testing::HasSubstr(messages::kNotObserved));
  EXPECT_THAT(text, testing::HasSubstr(messages::kByHand));
  for (const IniValue& value : iniValues(found, {}, "2026-11-26")) EXPECT_NE(value.key, "Neck");
}

TEST_F(OffsetFit, AnUncertainLoadMakesAnUncertainOffset) {
  const std::vector<JointOffset> found = fitOffsets(exactPoints(gravity, sweepPostures(), 0.001), gravity);
  const auto foot = std::ranges::find(found, Joint::kFootR, &JointOffset::joint);
  ASSERT_NE(foot, found.end());
  EXPECT_FALSE(foot->observed);
  EXPECT_GT(foot->sigma_rad, 0.02);
}

TEST_F(OffsetFit, TheOldOffsetIsPartOfTheNewOneInRobotIni) {
  cm730::JointOffsets before;
  before.set(Joint::kHead, Rad{-0.02});
  const std::vector<JointOffset> found{{Joint::kHead, 0.05, 0.001, true}, {Joint::kNeck, 0.3, 0.001, true}};
  const std::string text = withValues("[Offsets]\nHead = -0.020\n", "Offsets", iniValues(found, before, "2026-11-26"));
  EXPECT_NEAR(connect::parseRobotFile(text, "robot.ini").offsets.ticks(Joint::kHead) * kRadPerTick, 0.03, kRadPerTick);
  EXPECT_THAT(text, testing::HasSubstr("2026-11-26"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("Neck"))) << "beyond the range of the file";
  EXPECT_THAT(asText(found, before), testing::HasSubstr(messages::kHornIsFarOff));
}

TEST(SweepPlan, EveryGoalIsWithinTheLimitsOfItsJoint) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const SweepOfJoint sweep = sweepOf(joint);
    constexpr double kOffset = 0.06;  // 3 deg
    EXPECT_GT(sweep.base_rad - sweep.amplitude_rad, radFromTicks(row(joint).low).value + kOffset) << row(joint).name;
    EXPECT_LT(sweep.base_rad + sweep.amplitude_rad, radFromTicks(row(joint).high).value - kOffset) << row(joint).name;
  }
}

TEST(SweepPlan, ALimbThatLacksAJointIsLeftOut) {
  std::bitset<kJoints> absent;
  absent.set(index(Joint::kArmLowerL));
  const std::bitset<kJoints> swept = sweptJoints(absent);
  EXPECT_FALSE(swept[index(Joint::kShoulderL)]);
  EXPECT_TRUE(swept[index(Joint::kShoulderR)]);
  EXPECT_EQ(swept.count(), kJoints - 3);
}

TEST(SweepPlan, TheAngleThatIsAnnouncedIsThatOfTheWidestSweep) {
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_LE(sweepOf(static_cast<Joint>(i)).amplitude_rad, greatestSweepDeg() * kRadPerDegree) << kJointTable[i].name;
  EXPECT_EQ(greatestSweepDeg(), 52) << "as in docs/calibrate.md";
}

}  // namespace
}  // namespace darwinop::calibrate
