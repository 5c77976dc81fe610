// The player by hand: sections, chains, stops, and what is refused. The numbers were worked out with pencil and paper
// from the formulas of docs/motions.md.
#include "managers/motion/player.hpp"

#include <gmock/gmock.h>

#include "managers/motion/pages.hpp"

namespace darwinop::motion {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

/// The first joint's way, from 2000, relative to it; one value a tick.
std::vector<int> wayOf(const PageFile& pages, int page = 1, int stop_at = -1) {
  Player player{pages};
  EXPECT_TRUE(player.start(page, everywhere(2000)));
  std::vector<int> way;
  for (int tick = 0; tick < 3000; ++tick) {
    if (tick == stop_at) player.requestStop();
    if (!player.tick()) break;
    way.push_back(player.pose()[0] - 2000);
  }
  return way;
}

PageFile fileOf(const Page& page) {
  PageFile pages = emptyFile();
  pages[1] = page;
  return pages;
}

/// Pages 1, 2, ... that were played, each once a visit.
std::vector<int> visits(const PageFile& pages, int stop_at = -1) {
  Player player{pages};
  EXPECT_TRUE(player.start(1, everywhere(2000)));
  std::vector<int> seen;
  int step = 1;
  for (int tick = 0; tick < 400 && player.tick(); ++tick) {
    if (tick == stop_at) player.requestStop();
    if (player.step() == 0 && (step != 0 || seen.back() != player.page())) seen.push_back(player.page());
    step = player.step();
  }
  return seen;
}

// 10 ticks, 2 of them speeding up: V = 21333 / 32 = 666; way of the ramp (333 * 2 * 144 / 15) >> 9 = 12;
// main way 100 - 12 - (3196 >> 8) = 76.
TEST(Player, OneStepIsARampAConstantSpeedAndARamp) {
  EXPECT_THAT(wayOf(fileOf(pageOf({stepTo(2100, 10)}))),
              ElementsAre(0, 3, 12, 12, 24, 37, 50, 62, 75, 88, 88, 100, 100));
}

// Downwards ">>" rounds away from zero: the way there is not the mirror of the way back.
TEST(Player, DownwardsTheRoundingIsNotMirrored) {
  EXPECT_THAT(wayOf(fileOf(pageOf({stepTo(1900, 10)}))),
              ElementsAre(0, -4, -13, -13, -25, -37, -50, -62, -74, -87, -87, -100, -100));
}

// The first step hands its speed to the second: V = 21333 / (4 + 32) = 592, and nobody slows down in between.
TEST(Player, AStepInTheSameDirectionDoesNotStopInBetween) {
  const auto way = wayOf(fileOf(pageOf({stepTo(2100, 10), stepTo(2200, 10)})));
  ASSERT_EQ(way.size(), 26u);
  EXPECT_THAT(std::vector<int>(way.begin(), way.begin() + 13),
              ElementsAre(0, 2, 11, 11, 22, 33, 44, 55, 66, 77, 77, 100, 100));
  EXPECT_EQ(way.back(), 200);
}

TEST(Player, APauseHoldsAndTakesItsTicksAndOne) {
  const auto way = wayOf(fileOf(pageOf({stepTo(2100, 10, 5), stepTo(2200, 10)})));
  ASSERT_EQ(way.size(), 13u + 6u + 13u);
  EXPECT_THAT(std::vector<int>(way.begin() + 11, way.begin() + 20), ElementsAreArray(std::vector<int>(9, 100)));
  EXPECT_EQ(way[20], 103) << "from standing";
}

TEST(Player, HalfTheSpeedByteHalvesTheMoveAndDoublesThePause) {
  Page page = pageOf({stepTo(2100, 20, 5)});
  page.speed = 16;
  EXPECT_EQ(wayOf(fileOf(page)).size(), 10u + 3u + 10u + 1u);
}

TEST(Player, AStepThatIsTooShortGetsLessRampAndTheShortestDoesNotMove) {
  EXPECT_EQ(wayOf(fileOf(pageOf({stepTo(2100, 9)}, 32))).size(), 9u + 3u);
  EXPECT_THAT(wayOf(fileOf(pageOf({stepTo(2100, 2)}))), ElementsAre(0, 0, 0));
  EXPECT_THAT(wayOf(fileOf(pageOf({stepTo(2100, 0)}))), ElementsAre(0, 0, 0));
}

TEST(Player, ASpeedBasedStepTakesAsLongAsItsLongestWay) {
  Page page = pageOf({stepTo(2100, 10)});
  page.schedule = kSpeedBased;
  EXPECT_EQ(wayOf(fileOf(page)).size(), 40u * 100 / 30 + 3);
  page.step[0].position[20] = 2300;  // the head has farther to go, and all wait for it
  EXPECT_EQ(wayOf(fileOf(page)).size(), 40u * 300 / 30 + 3);
  page.step[0].position.fill(2000);
  EXPECT_EQ(wayOf(fileOf(page)).size(), 3u) << "nothing to do";
}

TEST(Player, AJointThatIsNotPartOfTheStepKeepsItsTarget) {
  for (const std::uint16_t flag : {kKeep, kUnusedWord, kTorqueOff}) {
    Page page = pageOf({stepTo(2100, 10)});
    page.step[0].position[1] = flag;
    EXPECT_THAT(wayOf(fileOf(page)), ElementsAreArray(std::vector<int>(13, 0)));
  }
}

TEST(Player, WhatIsOutOfRangeIsTheEndOfTheRange) {
  const auto way = wayOf(fileOf(pageOf({stepTo(0x9000, 100)})));
  EXPECT_EQ(*std::ranges::max_element(way), 4095 - 2000);
}

TEST(Player, PagesRepeatAndThenFollowEachOther) {
  PageFile pages = emptyFile();
  pages[1] = pages[2] = pages[3] = pageOf({stepTo(2100, 10), stepTo(2000, 10)});
  pages[1].repeat = 2;
  pages[1].next = 3;
  EXPECT_THAT(visits(pages), ElementsAre(1, 1, 3));
  pages[3].next = 2;
  EXPECT_THAT(visits(pages), ElementsAre(1, 1, 3, 2));
  pages[3].next = 4;
  EXPECT_THAT(visits(pages), ElementsAre(1, 1, 3)) << "page 4 is empty";
  pages[3].next = 2;
  pages[2].repeat = 0;
  EXPECT_THAT(visits(pages), ElementsAre(1, 1, 3)) << "page 2 has nothing to repeat";
}

TEST(Player, APageThatFollowsItselfGoesOnUntilItIsStopped) {
  Page page = pageOf({stepTo(2100, 10), stepTo(2000, 10)});
  page.next = 1;
  EXPECT_EQ(wayOf(fileOf(page)).size(), 3000u);
  EXPECT_EQ(wayOf(fileOf(page), 1, 500).size(), 520u) << "26 ticks a turn, and the one under way is finished";
}

TEST(Player, AStopLetsThePageEndAndGoesThroughItsExit) {
  PageFile pages = emptyFile();
  pages[1] = pages[2] = pages[5] = pageOf({stepTo(2100, 10), stepTo(2000, 10)});
  pages[1].repeat = 3;
  pages[1].next = 2;
  EXPECT_THAT(visits(pages, 5), ElementsAre(1));
  pages[1].exit = 5;
  EXPECT_THAT(visits(pages, 5), ElementsAre(1, 5));
  EXPECT_THAT(visits(pages, 15), ElementsAre(1, 1, 5)) << "the last step had chosen already";
}

TEST(Player, AStopIsForgottenByTheNextStart) {
  PageFile pages = emptyFile();
  pages[1] = pages[2] = pageOf({stepTo(2100, 10)});
  pages[1].next = 2;
  Player player{pages};
  const auto ticks = [&player] {
    int count = 0;
    while (player.tick()) ++count;
    return count;
  };
  ASSERT_TRUE(player.start(1, everywhere(2000)));
  player.requestStop();
  EXPECT_EQ(ticks(), 13);
  ASSERT_TRUE(player.start(1, everywhere(2000)));
  EXPECT_EQ(ticks(), 26);
}

TEST(Player, ABrakeEndsItWhereItIs) {
  const PageFile pages = fileOf(pageOf({stepTo(2100, 10)}));
  Player player{pages};
  ASSERT_TRUE(player.start(1, everywhere(2000)));
  for (int i = 0; i < 6; ++i) player.tick();
  player.brake();
  EXPECT_FALSE(player.tick());
  EXPECT_EQ(player.pose(), everywhere(2037));
  ASSERT_TRUE(player.start(1, player.pose()));
  while (player.tick()) continue;
  EXPECT_EQ(player.pose()[0], 2100) << "from where it was, afresh";
}

TEST(Player, WhatCannotBePlayedIsRefusedAndChangesNothing) {
  PageFile pages = fileOf(pageOf({stepTo(2100, 10)}));
  pages[3] = pages[1];
  pages[3].repeat = 0;
  Player player{pages};
  for (const int page : {-1, 0, 2, 3, 256, 100000}) EXPECT_FALSE(player.start(page, everywhere(2000))) << page;
  EXPECT_FALSE(player.isPlaying());
  ASSERT_TRUE(player.start(1, everywhere(2000)));
  player.tick();
  player.tick();
  EXPECT_FALSE(player.start(1, everywhere(1000))) << "one at a time";
  EXPECT_EQ(player.pose(), everywhere(2003));
}

TEST(Player, TheGainsAreThoseOfThePageBeingPlayed) {
  PageFile pages = emptyFile();
  pages[1] = pages[2] = pageOf({stepTo(2100, 10)});
  pages[1].slopes[3] = 0x77;
  pages[1].next = 2;
  Player player{pages};
  ASSERT_TRUE(player.start(1, everywhere(2000)));
  std::vector<int> gains;
  while (player.tick()) gains.push_back(player.pGainRegister(Joint::kArmUpperR));
  std::vector<int> expected(26, 32);
  std::fill_n(expected.begin(), 13, 8);
  EXPECT_EQ(gains, expected);
  EXPECT_EQ(player.pGainRegister(Joint::kShoulderL), 32);
}

}  // namespace
}  // namespace darwinop::motion
