// What check finds in pages, what it leaves alone, and how long pages take.
#include <gmock/gmock.h>

#include "managers/motion_text/check_pages.hpp"
#include "managers/motion_text/rehearsal.hpp"
#include "motion/pages.hpp"

namespace darwinop::motion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// All joints where every joint's limits allow them.
Step middle(std::uint8_t time) {
  return stepTo(2048, time);
}

PageFile fileWith(const Page& page) {
  PageFile pages = emptyFile();
  pages[5] = page;
  return pages;
}

TEST(CheckPages, NothingIsWrongWithAGentlePage) {
  EXPECT_THAT(checkPages(fileWith(pageOf({middle(125), middle(125)}))), IsEmpty());
  EXPECT_THAT(checkPages(emptyFile()), IsEmpty());
}

TEST(CheckPages, ChainsLeadToPagesThatHoldSomething) {
  Page page = pageOf({middle(125)});
  page.next = 6;
  page.exit = 0;
  EXPECT_THAT(checkPages(fileWith(page)), ElementsAre("page 5: next is page 6, which holds nothing to play"));
  page.next = 5;
  page.exit = 255;
  EXPECT_THAT(checkPages(fileWith(page)), ElementsAre("page 5: exit is page 255, which holds nothing to play"));
}

TEST(CheckPages, PositionsAreWithinTheJointsLimits) {
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
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty()) << "it is never played";
}

TEST(CheckPages, TheServoCanFollow) {
  Page page = pageOf({middle(125), middle(10)});
  page.step[1].position[19] = 2048 + 640;  // 64 ticks in 8 ms would be 12.27 rad/s
  EXPECT_THAT(checkPages(fileWith(page)),
              ElementsAre("page 5, step 2, Neck: 56.25 degrees in 0.080 s are 703 degrees/s; the servo's most is 702"));
  --page.step[1].position[19];
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty());
}

TEST(CheckPages, TheWayBackToTheFirstStepCountsToo) {
  Page page = pageOf({middle(10), middle(125)});
  page.step[1].position[19] = 2800;
  EXPECT_THAT(checkPages(fileWith(page)), IsEmpty());
  page.repeat = 2;
  EXPECT_THAT(checkPages(fileWith(page)),
              ElementsAre("page 5, step 1, Neck: 66.09 degrees in 0.080 s are 826 degrees/s; the servo's most is 702"));
}

TEST(CheckPages, TheWayToTheNextPageCountsToo) {
  Page page = pageOf({middle(125)});
  page.next = 6;
  PageFile pages = fileWith(page);
  pages[6] = pageOf({middle(10)});
  pages[6].step[0].position[19] = 2800;
  EXPECT_THAT(checkPages(pages), ElementsAre("page 6, step 1, Neck: 66.09 degrees in 0.080 s are 826 degrees/s; the "
                                             "servo's most is 702, coming from page 5"));
}

TEST(CheckBytes, EveryDamagedPageIsNamedAndTheOthersAreRead) {
  const PageFile good = fileWith(pageOf({middle(125)}));
  std::vector<std::uint8_t> bytes = encodePages(good);
  PageFile pages;
  EXPECT_THAT(checkBytes(bytes, pages), IsEmpty());
  EXPECT_EQ(pages, good);
  bytes[3 * kPageBytes + 40] ^= 1U;
  bytes[200 * kPageBytes] ^= 2U;
  const auto damages = checkBytes(bytes, pages);
  ASSERT_EQ(damages.size(), 2u);
  EXPECT_TRUE(damages[0].starts_with("page 3, byte 1567: the checksum is wrong")) << damages[0];
  EXPECT_TRUE(damages[1].starts_with("page 200, byte 102431: the checksum is wrong")) << damages[1];
  EXPECT_EQ(pages, good) << "the damaged ones are empty, as they were";
  bytes.pop_back();
  EXPECT_EQ(checkBytes(bytes, pages).size(), 1u);
  EXPECT_THAT(pages, IsEmpty());
}

// Source of the numbers: N + 3 calls a step and pause + 1 for a pause, as the vendor's engine has it.
TEST(Duration, IsWhatTheEngineTakes) {
  Page page = pageOf({middle(50), stepTo(2100, 50, 25)}, 32);
  EXPECT_EQ(ticksOf(fileWith(page), 5), 53 + 53 + 26);
  page.speed = 16;
  page.repeat = 3;
  page.next = 5;
  EXPECT_EQ(ticksOf(fileWith(page), 5), 3 * (28 + 28 + 51));
  page.repeat = 0;
  EXPECT_EQ(ticksOf(fileWith(page), 5), 0);
}

}  // namespace
}  // namespace darwinop::motion
