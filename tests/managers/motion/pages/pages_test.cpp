// Built-in pages: numbers, names, limits, final poses.
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "managers/gait/walk.hpp"
#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion/pages/promised_poses.hpp"
#include "managers/motion_text/check_pages.hpp"
#include "managers/motion_text/mirror.hpp"

namespace darwinop::motion {
namespace {

using testing::IsEmpty;

constexpr std::size_t kWalkReady = 9, kRightKick = 12, kLeftKick = 13, kSitDown = 15;

TEST(OwnPages, HaveTheNumbersUsedByControllers) {
  const PageFile pages = ownPages();
  std::map<std::size_t, std::string> names;
  for (std::size_t i = 0; i < kPages; ++i)
    if (pages[i].canPlay()) names[i] = pages[i].nameText();
  const std::map<std::size_t, std::string> expected{
      {1, "init"}, {2, "ok"},  {3, "no"},        {4, "hi"},        {9, "walkready"}, {10, "f up"},    {11, "b up"},
      {12, "rk"},  {13, "lk"}, {15, "sit down"}, {16, "stand up"}, {24, "hello"},    {38, "bye bye"},  // no message
  };
  EXPECT_EQ(names, expected);
}

TEST(OwnPages, StayWithinLimitsAndSpeeds) {
  EXPECT_THAT(checkPages(ownPages()), IsEmpty());
}

TEST(OwnPages, MoveEveryJointInEveryStepAndEnd) {
  const PageFile pages = ownPages();
  for (std::size_t i = 1; i < kPages; ++i) {
    EXPECT_EQ(pages[i].next, 0) << "page " << i;
    for (std::size_t step = 0; step < pages[i].steps; ++step)
      for (std::size_t id = 1; id <= kJoints; ++id)
        EXPECT_LE(pages[i].step[step].position[id], kTickMax) << "page " << i << ", step " << step + 1 << ", id " << id;
  }
}

TEST(OwnPages, EndInTheStanceOrSitting) {
  const PageFile pages = ownPages();
  for (std::size_t i = 1; i < kPages; ++i) {
    if (pages[i].canPlay()) {
      EXPECT_EQ(lastPose(pages[i]), i == kSitDown ? sitting() : stance()) << "page " << i;
    }
  }
}

TEST(OwnPages, TheEngineEndsInTheFinalPose) {
  const PageFile pages = ownPages();
  for (std::size_t i = 1; i < kPages; ++i) {
    if (!pages[i].canPlay()) continue;
    Player player{pages};
    ASSERT_TRUE(player.start(static_cast<int>(i), stance()));
    while (player.tick()) {
    }
    const Pose promised = lastPose(pages[i]);
    for (std::size_t j = 0; j < kJoints; ++j)
      EXPECT_NEAR(player.pose()[j], promised[j], 2) << "page " << i << ", " << kJointTable[j].name;
  }
}

TEST(OwnPages, WalkingStartsFromTheStanceWithoutAnApproach) {
  const Pose ready = lastPose(ownPages()[kWalkReady]);
  gait::Goals goals;
  std::copy_n(ready.begin(), gait::kWalkingJoints, goals.tick.begin());
  gait::Walk walk{gait::Parameters{}};
  walk.start(gait::poseOf(goals));
  EXPECT_EQ(walk.approachMs(), 0);
}

// Except the last step: the stance is not exactly symmetric.
TEST(OwnPages, TheLeftKickIsTheRightOneMirrored) {
  const PageFile pages = ownPages();
  const Page &left = pages[kLeftKick], mirror = mirrored(pages[kRightKick]);
  ASSERT_EQ(left.steps, mirror.steps);
  EXPECT_EQ(left.slopes, mirror.slopes);
  for (std::size_t step = 0; step < left.steps; ++step) {
    EXPECT_EQ(left.step[step].time, mirror.step[step].time);
    EXPECT_EQ(left.step[step].pause, mirror.step[step].pause);
    if (step + 1U < left.steps) {
      EXPECT_EQ(left.step[step].position, mirror.step[step].position) << "step " << step + 1;
    }
  }
}

TEST(OwnPages, AreUnchangedByTheBinaryFormat) {
  const PageFile pages = ownPages();
  EXPECT_EQ(decodePages(encodePages(pages)), pages);
}

}  // namespace
}  // namespace darwinop::motion
