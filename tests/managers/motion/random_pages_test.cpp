// Random pages: the player does what the rules say, in any chain, from any pose, with a stop at any tick.
#include <gtest/gtest.h>

#include "managers/motion/naive.hpp"
#include "managers/motion/pages.hpp"

namespace darwinop::motion {
namespace {

Pose randomPose(std::mt19937& dice) {
  Pose pose;
  for (int& ticks : pose) ticks = static_cast<int>(dice() % 4096);
  return pose;
}

TEST(RandomPages, ThePlayerDoesWhatTheRulesSay) {
  std::mt19937 dice{11};
  std::size_t ticks = 0;
  for (int run = 0; run < 300; ++run) {
    const PageFile pages = randomFile(dice);
    const int page = 1 + static_cast<int>(dice() % 11);
    const int stop_at = dice() % 2 == 0 ? static_cast<int>(dice() % 500) : -1;
    const Pose present = randomPose(dice);
    Player player{pages};
    ASSERT_EQ(player.start(page, present), pages[static_cast<std::size_t>(page)].canPlay());
    if (!player.isPlaying()) continue;
    const auto expected = naive::play(pages, page, present, 2000, stop_at);
    for (std::size_t tick = 0; tick < expected.size(); ++tick, ++ticks) {
      if (static_cast<int>(tick) == stop_at) player.requestStop();
      ASSERT_TRUE(player.tick()) << run << ' ' << tick;
      ASSERT_EQ(player.pose(), expected[tick].pose) << run << ' ' << tick;
      ASSERT_EQ(player.page(), expected[tick].page) << run << ' ' << tick;
      ASSERT_EQ(player.step(), expected[tick].step) << run << ' ' << tick;
    }
    ASSERT_EQ(player.tick(), expected.size() == 2000);
  }
  EXPECT_GT(ticks, 100'000u);
}

// What the joints' speed promises: 1023 units are 2.4 * 1023 / 256 ticks a call at most, and the two ends of a
// section add rounding. Steps too short to move in are left out: they are jumps by design of the format.
TEST(RandomPages, TheFirstMoveFromAnyPoseBeginsGently) {
  std::mt19937 dice{12};
  for (int run = 0; run < 200; ++run) {
    PageFile pages = emptyFile();
    pages[1] = pageOf({stepTo(static_cast<std::uint16_t>(dice() % 4096), 125)}, 32);
    Player player{pages};
    const Pose present = randomPose(dice);
    ASSERT_TRUE(player.start(1, present));
    Pose before = present;
    for (int tick = 0; player.tick(); ++tick) {
      for (std::size_t i = 0; i < kJoints; ++i) {
        ASSERT_LE(std::abs(player.pose()[i] - before[i]), tick < 5 ? 3 : 64) << run << ' ' << tick;
      }
      before = player.pose();
    }
  }
}

}  // namespace
}  // namespace darwinop::motion
