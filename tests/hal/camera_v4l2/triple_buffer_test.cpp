// Handing large values over without waiting.
#include "hal/triple_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

namespace darwinop::v4l2 {
namespace {

TEST(TripleBuffer, BeginsWithTheSameEverywhereAndNothingNew) {
  TripleBuffer<int> buffer{7};
  EXPECT_EQ(buffer.front(), 7);
  EXPECT_EQ(buffer.back(), 7);
  EXPECT_FALSE(buffer.update());
}

TEST(TripleBuffer, GivesTheNewestAndEachOnce) {
  TripleBuffer<int> buffer{0};
  for (int value = 1; value <= 5; ++value) {
    buffer.back() = value;
    buffer.publish();
  }
  EXPECT_TRUE(buffer.update());
  EXPECT_EQ(buffer.front(), 5);
  EXPECT_FALSE(buffer.update());
  EXPECT_EQ(buffer.front(), 5);
}

TEST(TripleBuffer, LeavesAloneWhatTheReaderLooksAt) {
  TripleBuffer<int> buffer{0};
  buffer.back() = 1;
  buffer.publish();
  buffer.update();
  const int& seen = buffer.front();
  for (int value = 2; value < 20; ++value) {
    EXPECT_NE(&buffer.back(), &seen);
    buffer.back() = value;
    buffer.publish();
    EXPECT_EQ(seen, 1);
  }
}

TEST(TripleBuffer, NeverShowsHalfAValueNorAnOlderOne) {
  using Value = std::array<int, 256>;
  TripleBuffer<Value> buffer{Value{}};
  constexpr int kValues = 20'000;
  std::thread writer{[&] {
    for (int value = 1; value <= kValues; ++value) {
      buffer.back().fill(value);
      buffer.publish();
    }
  }};
  int last = 0, torn = 0, older = 0;
  while (last < kValues) {
    buffer.update();
    const Value& seen = buffer.front();
    const int first = seen.front();
    if (std::count(seen.begin(), seen.end(), first) != std::ssize(seen)) ++torn;
    if (first < last) ++older;
    last = first;
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(older, 0);
}

}  // namespace
}  // namespace darwinop::v4l2
