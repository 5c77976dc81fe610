// Once it is made, the player allocates nothing.
#include <gtest/gtest.h>

#include "managers/motion/pages.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::motion {
namespace {

TEST(PlayerAllocation, NoPageAndNoRequestAllocates) {
  std::mt19937 dice{3};
  const PageFile pages = randomFile(dice);
  Player player{pages};
  const long before = allocationsOfThisThread();
  int ticks = 0;
  for (int page = 0; page < static_cast<int>(kPages); ++page) {
    if (!player.start(page, everywhere(2048))) continue;
    for (int i = 0; i < 3000 && player.tick(); ++i) {
      ticks += player.pGainRegister(Joint::kNeck) >= 0 ? 1 : 0;
      if (i == 1000) player.requestStop();
    }
    player.brake();
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
  EXPECT_GT(ticks, 5000);
}

}  // namespace
}  // namespace darwinop::motion
