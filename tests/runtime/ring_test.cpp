// Queue between two threads: order kept, nothing lost silently.
#include "runtime/ring.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>

namespace darwinop::runtime {
namespace {

TEST(Ring, GivesItemsInOrderAndCountsThoseThatDoNotFit) {
  Ring<int, 4> ring;
  EXPECT_EQ(ring.front(), nullptr);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(ring.push(i), i < 4);
  EXPECT_EQ(ring.size(), 4u);
  EXPECT_EQ(ring.dropped(), 2u);
  for (int i = 0; i < 4; ++i) {
    ASSERT_NE(ring.front(), nullptr);
    EXPECT_EQ(*ring.front(), i);
    ring.pop();
  }
  EXPECT_EQ(ring.front(), nullptr);
  EXPECT_TRUE(ring.push(9));
  EXPECT_EQ(*ring.front(), 9);
}

TEST(Ring, CarriesEveryItemBetweenTwoThreadsOrCountsIt) {
  struct Item {
    std::uint32_t number, check;
  };
  Ring<Item, 64> ring;
  constexpr std::uint32_t kItems = 200'000;
  std::uint32_t taken = 0;
  std::thread popper{[&] {
    std::uint32_t last = 0;
    while (last != kItems) {
      const Item* item = ring.front();
      if (item == nullptr) continue;
      ASSERT_GT(item->number, last);
      ASSERT_EQ(item->check, ~item->number);
      last = item->number;
      ++taken;
      ring.pop();
    }
  }};
  for (std::uint32_t n = 1; n < kItems; ++n) ring.push({n, ~n});
  const std::uint32_t dropped = ring.dropped();
  while (!ring.push({kItems, ~kItems})) std::this_thread::yield();
  popper.join();
  EXPECT_EQ(taken + dropped, kItems);
}

}  // namespace
}  // namespace darwinop::runtime
