// Checks of motion pages, durations, dry runs.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "managers/motion/pages.hpp"
#include "managers/motion_text/check_pages.hpp"
#include "managers/motion_text/dry_run.hpp"

namespace darwinop::motion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A pose within all joint limits.
Step middle(std::uint8_t time) {
  return stepTo(2048, time);
}

PageFile fileWith(const Page& page) {
  PageFile pages = emptyFile();
  pages[5] = page;
  return pages;
}

TEST(CheckPages, AValidPageHasNoFindings) {
  EXPECT_THAT(checkPages(fileWith(pageOf({middle(125), middle(125)}))), IsEmpty());
  EXPECT_THAT(checkPages(emptyFile()), IsEmpty());
}

TEST(CheckPages, LinksMustLeadToPlayablePages) {
  Page page = pageOf({middle(125)});
  page.next = 6;
  page.exit = 0;
  EXPECT_THAT(checkPages(fileWith(page)), ElementsAre("page 5: next is page 6, which is empty"));
  page.next = 0;
  page.exit = 255;
  EXPECT_THAT(checkPages(fileWith(page)), ElementsAre("page 5: exit is page 255, which is empty"));
}

TEST(CheckPages, PositionsMustBeWithinTheJointLimits) {
  Page page = pageOf({middle(125), middle(125)});
  page.step[1].position[19] = 789;
  page.step[1].position[20] = 2661;
  page.step[0].position[20] = page.step[1].position[18] = kKeep;
  page.step[0].position[17] = 0x1000;
  EXPECT_THAT(checkPages(fileWith(page)),
              ElementsAre("page 5, step 1, FootR: 0x1000 is neither a position nor 'keep'",
                          "page 5, step 2, Neck: -110.65 degrees is below the joint's limit, -110.57",
                          "page 5, step 2, Head: 53.88 degrees is above the joint's limit, 53.79"));
  page.steps = 0;
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty()) << "not playable";
}

TEST(CheckPages, SpeedsMustBeFeasible) {
  Page page = pageOf({middle(125), middle(10)});
  page.step[1].position[19] = 2048 + 640;  // 64 ticks in 8 ms would be 12.27 rad/s
  EXPECT_THAT(
      checkPages(fileWith(page)),
      ElementsAre("page 5, step 2, Neck: 56.25 degrees in 0.080 s are 703 degrees/s; the servo's maximum is 702"));
  --page.step[1].position[19];
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty());
}

TEST(CheckPages, AStepTooShortForAMotionIsAJump) {
  Page page = pageOf({middle(125), middle(2), middle(125)});
  page.step[1].position[19] = 2048 + 12;
  page.step[1].position[20] = 2048 - 11;
  EXPECT_THAT(checkPages(fileWith(page)),
              ElementsAre("page 5, step 2, Neck: the goal jumps by 1.05 degrees: 0.016 s are too short for a motion"));
  --page.step[1].position[19];
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty()) << "below the threshold of a jump";
  page.step[1].position[19] = 2048 + 100;
  page.step[1].time = 3;
  page.step[1].position[19] = 2048 + 30;
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty()) << "short, but with a motion";
}

TEST(CheckPages, AShortStepWithoutAccelerationReachesItsTarget) {
  Page page = pageOf({middle(125), middle(2), middle(125)});
  page.acceleration = 0;
  page.step[1].position[19] = 2048 + 12;
  const PageFile pages = fileWith(page);
  EXPECT_THAT(checkPages(pages), IsEmpty());
  int farthest = 0, jump = 0, before = 2048;
  for (const Pose& pose : dryRun(pages, 5, firstPose(page)).poses) {
    farthest = std::max(farthest, pose[18]);
    jump = std::max(jump, std::abs(pose[18] - std::exchange(before, pose[18])));
  }
  EXPECT_EQ(farthest, 2048 + 12);
  EXPECT_EQ(jump, 6) << "in two ticks";
}

TEST(CheckPages, LowGainsAreReported) {
  Page page = pageOf({middle(125)});
  page.slopes[19] = 0x99;
  page.slopes[20] = page.slopes[2] = 0x88;
  page.slopes[13] = 0x8F;
  page.slopes[14] = 0x77;
  page.slopes[21] = 0xFF;
  EXPECT_THAT(checkPages(fileWith(page)),
              ElementsAre("page 5, LegLowerR: with a P gain of 4 the leg collapses; the minimum is 8",
                          "page 5, Neck: its P gain is 0; the joint is limp while the page is played"));
  page.repeat = 0;
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty()) << "not playable";
}

TEST(CheckPages, AnEndlessChainIsReportedOnceAndAnExitDoesNotEndIt) {
  PageFile pages = fileWith(pageOf({middle(125)}));
  pages[7] = pages[6] = pages[5];
  pages[5].next = 7;
  pages[7].next = 5;
  pages[6].next = 7;
  EXPECT_THAT(checkPages(pages), ElementsAre("page 5: 5 -> 7 -> 5 never ends"));
  pages[7].exit = 6;
  EXPECT_THAT(checkPages(pages), ElementsAre("page 5: 5 -> 7 -> 5 never ends"));
  pages[7].exit = 0;
  pages[7].next = 7;
  EXPECT_THAT(checkPages(pages), ElementsAre("page 7: 7 -> 7 never ends"));
  pages[7].next = 0;
  EXPECT_THAT(checkPages(pages), IsEmpty()) << "the chain ends";
}

TEST(CheckPages, TheReturnToTheFirstStepIsChecked) {
  Page page = pageOf({middle(10), middle(125)});
  page.step[1].position[19] = 2800;
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty());
  page.repeat = 2;
  EXPECT_THAT(
      checkPages(fileWith(page)),
      ElementsAre("page 5, step 1, Neck: 66.09 degrees in 0.080 s are 826 degrees/s; the servo's maximum is 702"));
}

TEST(CheckPages, TheTransitionToTheNextPageIsChecked) {
  Page page = pageOf({middle(125)});
  page.next = 6;
  PageFile pages = fileWith(page);
  pages[6] = pageOf({middle(10)});
  pages[6].step[0].position[19] = 2800;
  EXPECT_THAT(checkPages(pages), ElementsAre("page 6, step 1, Neck: 66.09 degrees in 0.080 s are 826 degrees/s; the "
                                             "servo's maximum is 702, coming from page 5"));
}

TEST(CheckBytes, EveryDamagedPageIsReportedAndTheOthersAreRead) {
  const PageFile good = fileWith(pageOf({middle(125)}));
  std::vector<std::uint8_t> bytes = encodePages(good);
  PageFile pages;
  EXPECT_THAT(checkBytes(bytes, pages), IsEmpty());
  EXPECT_EQ(pages, good);
  bytes[3 * kPageBytes + 40] ^= 1U;
  bytes[200 * kPageBytes] ^= 2U;
  const auto damages = checkBytes(bytes, pages);
  ASSERT_EQ(damages.size(), 2u);
  EXPECT_TRUE(damages[0].starts_with("page 3, byte 1567: wrong checksum")) << damages[0];
  EXPECT_TRUE(damages[1].starts_with("page 200, byte 102431: wrong checksum")) << damages[1];
  EXPECT_EQ(pages, good) << "damaged pages are empty";
  bytes.pop_back();
  EXPECT_EQ(checkBytes(bytes, pages).size(), 1u);
  EXPECT_THAT(pages, IsEmpty());
}

// N + 3 calls per step and pause + 1 per pause, as in the vendor's engine.
TEST(Duration, EqualsThatOfTheEngine) {
  Page page = pageOf({middle(50), stepTo(2100, 50, 25)}, 32);
  EXPECT_EQ(ticksOf(fileWith(page), 5), 53 + 53 + 26);
  page.speed = 16;
  page.repeat = 3;
  page.next = 0;
  EXPECT_EQ(ticksOf(fileWith(page), 5), 3 * (28 + 28 + 51));
  page.repeat = 0;
  EXPECT_EQ(ticksOf(fileWith(page), 5), 0);
}

TEST(DryRun, PlaysAPageAndItsSuccessors) {
  Page page = pageOf({middle(50), stepTo(2100, 25)}, 8);
  page.next = 6;
  PageFile pages = fileWith(page);
  pages[6] = pageOf({stepTo(2000, 20)}, 8);
  const DryRun played = dryRun(pages, 5, everywhere(2048));
  ASSERT_EQ(played.sections.size(), 2u);
  EXPECT_THAT(played.sections[0].steps, ElementsAre(0u, 53u)) << "a step takes 3 additional ticks";
  EXPECT_EQ(played.sections[1].page, 6);
  EXPECT_EQ(played.sections[1].begin, 53u + 28u);
  EXPECT_EQ(played.poses.size(), 1u + 53 + 28 + 23);
  EXPECT_EQ(played.poses.front(), everywhere(2048));
  EXPECT_EQ(played.poses.back(), everywhere(2000));
  EXPECT_FALSE(played.cut);
}

TEST(DryRun, PlaysAnEndlessChainOnceAndAtMostAMinute) {
  PageFile pages = fileWith(pageOf({middle(50)}));
  pages[6] = pages[5];
  pages[5].next = 6;
  pages[6].next = 5;
  const DryRun ring = dryRun(pages, 5, everywhere(2048));
  EXPECT_EQ(ring.sections.size(), 2u);
  EXPECT_TRUE(ring.cut);
  pages[5].next = 5;
  const DryRun itself = dryRun(pages, 5, everywhere(2048));
  EXPECT_TRUE(itself.cut);
  EXPECT_EQ(itself.poses.size(), 1u + 53);
  pages[5].next = 0;
  pages[5].repeat = 255;
  const DryRun long_one = dryRun(pages, 5, everywhere(2048));
  EXPECT_TRUE(long_one.cut);
  EXPECT_NEAR(static_cast<double>(long_one.poses.size()) * 0.008, 60, 0.1);
}

}  // namespace
}  // namespace darwinop::motion
