// Left and right swapped: where everything goes, and that twice is the same page again.
#include "managers/motion_text/mirror.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "managers/motion/pages.hpp"
#include "managers/motion_text/any_pages.hpp"

namespace darwinop::motion {
namespace {

RC_GTEST_PROP(Mirror, TwiceIsTheSamePage, (std::uint32_t seed)) {
  std::mt19937 dice{seed};
  Page page = anyPage(dice);
  for (Step& step : page.step)
    for (std::uint16_t& word : step.position) word = std::max<std::uint16_t>(word, 1);  // see the next test
  RC_ASSERT(mirrored(mirrored(page)) == page);
}

TEST(Mirror, TickZeroHasNone) {
  const Page page = mirrored(pageOf({stepTo(0, 10)}));
  EXPECT_EQ(page.step[0].position[1], 4095);
  EXPECT_EQ(mirrored(page).step[0].position[2], 1);
}

TEST(Mirror, EverythingGoesToItsPlace) {
  Page page = pageOf({stepTo(kUnusedWord, 10, 3)});
  page.step[0].position[1] = 1500;   // right shoulder, 548 below the middle
  page.step[0].position[14] = 2100;  // left knee
  page.step[0].position[17] = kKeep;
  page.step[0].position[19] = 2000;  // pan
  page.step[0].position[20] = 2200;  // tilt
  page.step[0].position[0] = page.step[0].position[21] = 7;
  page.slopes[3] = 0x57;
  const Page other = mirrored(page);
  EXPECT_EQ(other.step[0].position[2], 2596);
  EXPECT_EQ(other.step[0].position[1], kUnusedWord);
  EXPECT_EQ(other.step[0].position[13], 1996);
  EXPECT_EQ(other.step[0].position[18], kKeep);
  EXPECT_EQ(other.step[0].position[19], 2096);
  EXPECT_EQ(other.step[0].position[20], 2200);
  EXPECT_EQ(other.step[0].position[0], 7) << "no joint";
  EXPECT_EQ(other.step[0].position[21], 7) << "no joint";
  EXPECT_EQ(other.slopes[4], 0x57) << "the partner has the same gain";
  EXPECT_EQ(other.slopes[3], kUsualSlopes);
  EXPECT_EQ(other.step[0].time, 10);
  EXPECT_EQ(other.step[0].pause, 3);
}

}  // namespace
}  // namespace darwinop::motion
