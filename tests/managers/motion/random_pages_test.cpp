// Random pages: the player equals the reference implementation, for any chain, initial pose and stop.
#include <gtest/gtest.h>

#include "managers/motion/naive.hpp"
#include "managers/motion/pages.hpp"

namespace darwinop::motion {
namespace {

Pose randomPose(std::mt19937& rng) {
  Pose pose;
  for (int& ticks : pose) ticks = static_cast<int>(rng() % 4096);
  return pose;
}

TEST(RandomPages, ThePlayerEqualsTheReference) {
  std::mt19937 rng{11};
  std::size_t ticks = 0;
  for (int run = 0; run < 300; ++run) {
    const PageFile pages = randomFile(rng);
    const int page = 1 + static_cast<int>(rng() % 11);
    const int stop_at = rng() % 2 == 0 ? static_cast<int>(rng() % 500) : -1;
    const Pose present = randomPose(rng);
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

// Speed bound: 1023 units are at most 2.4 * 1023 / 256 ticks per call, plus rounding at both ends of a section. Steps
// too short for a motion are excluded: they are jumps by design of the format.
TEST(RandomPages, TheFirstStepFromAnyPoseIsLimitedInSpeed) {
  std::mt19937 rng{12};
  for (int run = 0; run < 200; ++run) {
    PageFile pages = emptyFile();
    pages[1] = pageOf({stepTo(static_cast<std::uint16_t>(rng() % 4096), 125)}, 32);
    Player player{pages};
    const Pose present = randomPose(rng);
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
