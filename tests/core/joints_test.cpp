// The joint table against figures that were not used to make it.
#include "core/joints.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/conversions.hpp"

namespace darwinop {
namespace {

TEST(Joints, AreFoundByTheirWebotsName) {
  for (const JointRow& joint : kJointTable) {
    const auto found = findJoint(joint.name);
    ASSERT_TRUE(found) << joint.name;
    EXPECT_EQ(row(*found).id, joint.id);
  }
  EXPECT_EQ(findJoint("Neck"), Joint::kNeck);
  EXPECT_FALSE(findJoint("neck"));
  EXPECT_FALSE(findJoint("NeckS"));
  EXPECT_FALSE(findJoint(""));
}

TEST(Joints, HangOnFiveChainsInThisOrder) {
  std::map<Chain, std::vector<int>> chains;
  for (const JointRow& joint : kJointTable) chains[joint.chain].push_back(joint.id);
  EXPECT_EQ(chains[Chain::kRightArm], (std::vector{1, 3, 5}));
  EXPECT_EQ(chains[Chain::kLeftArm], (std::vector{2, 4, 6}));
  EXPECT_EQ(chains[Chain::kHead], (std::vector{19, 20}));
  EXPECT_EQ(chains[Chain::kRightLeg], (std::vector{7, 9, 11, 13, 15, 17}));
  EXPECT_EQ(chains[Chain::kLeftLeg], (std::vector{8, 10, 12, 14, 16, 18}));
}

TEST(Joints, OfTheLegsAreSevenToEighteen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto chain = kJointTable[i].chain;
    EXPECT_EQ(isLeg(static_cast<Joint>(i)), chain == Chain::kRightLeg || chain == Chain::kLeftLeg);
  }
}

/// Limits of the simulator's model, rad, as its authors rounded them. Left out where they differ on purpose:
/// the simulator lets ShoulderR turn to -3.14 and the neck only to -1.81.
TEST(Joints, LimitsAgreeWithTheSimulatorsModel) {
  struct Row {
    Joint joint;
    double low, high;
  };
  constexpr std::array kModel = std::to_array<Row>({
      {Joint::kShoulderL, -3.14, 2.85},
      {Joint::kArmUpperR, -0.68, 2.3},
      {Joint::kArmUpperL, -2.25, 0.77},
      {Joint::kArmLowerR, -1.65, 1.16},
      {Joint::kArmLowerL, -1.18, 1.63},
      {Joint::kPelvYR, -2.42, 0.66},
      {Joint::kPelvYL, -0.69, 2.5},
      {Joint::kPelvR, -1.01, 1.01},
      {Joint::kPelvL, -1, 0.93},
      {Joint::kLegUpperR, -1.77, 0.45},
      {Joint::kLegUpperL, -0.5, 1.68},
      {Joint::kLegLowerR, -0.02, 2.25},
      {Joint::kLegLowerL, -2.25, 0.03},
      {Joint::kAnkleR, -1.24, 1.38},
      {Joint::kAnkleL, -1.39, 1.22},
      {Joint::kFootR, -0.68, 1.04},
      {Joint::kFootL, -1.02, 0.6},
      {Joint::kHead, -0.36, 0.94},
  });
  for (const Row& model : kModel) {
    EXPECT_NEAR(radFromTicks(row(model.joint).low).value, model.low, 0.02) << row(model.joint).name;
    EXPECT_NEAR(radFromTicks(row(model.joint).high).value, model.high, 0.02) << row(model.joint).name;
  }
}

TEST(Joints, LeftShouldersDisputedLimitMirrorsTheRightOne) {
  EXPECT_EQ(row(Joint::kShoulderL).high, 4096 - row(Joint::kShoulderR).low);
}

TEST(Joints, StartPoseIsNearlyTheSameLeftAndRight) {
  // Measured on a robot in 2013, so partners differ; a swapped or mistyped row differs by far more.
  for (std::size_t right = 0; right < 18; right += 2) {
    const double a = radFromTicks(kJointTable[right].start).value;
    const double b = radFromTicks(kJointTable[right + 1].start).value;
    EXPECT_NEAR(a, -b, 0.15) << kJointTable[right].name;
  }
}

RC_GTEST_PROP(JointSets, HoldTheJointsForWhichTheConditionIsTrueAndVisitThemInOrder, ()) {
  const auto bits = *rc::gen::container<std::vector<bool>>(kJoints, rc::gen::arbitrary<bool>());
  std::vector<std::size_t> asked, visited, expected;
  const std::bitset<kJoints> joints = jointsThat([&](std::size_t i) {
    asked.push_back(i);
    return static_cast<bool>(bits[i]);
  });
  for (std::size_t i = 0; i < kJoints; ++i) {
    RC_ASSERT(joints[i] == bits[i]);
    if (bits[i]) expected.push_back(i);
  }
  forEachJoint(joints, [&](std::size_t i) { visited.push_back(i); });
  RC_ASSERT(visited == expected);
  std::ranges::sort(asked);
  RC_ASSERT(asked.size() == kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) RC_ASSERT(asked[i] == i);
}

TEST(JointSets, AnyTrueValueCounts) {
  EXPECT_EQ(jointsThat([](std::size_t i) { return i == 3 || i == 19 ? 0x100 : 0; }).to_ulong(), 1UL << 3 | 1UL << 19);
}

TEST(JointSets, OfNoJointVisitNone) {
  forEachJoint({}, [](std::size_t i) { FAIL() << i; });
}

TEST(Joints, AreNamedAsInTheTableInAnyCase) {
  EXPECT_EQ(jointName("legupperr"), "LegUpperR");
  EXPECT_EQ(jointName("NECK"), "Neck");
  EXPECT_EQ(jointName("NeckS"), "NeckS") << "a key that names no joint";
  EXPECT_EQ(jointName(""), "");
}

}  // namespace
}  // namespace darwinop
