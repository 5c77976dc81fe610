#include "supervisor/heartbeat.hpp"

#include <gtest/gtest.h>

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;

/// Time from the first check until a hanging loop with this period is detected; a check every 20 ms.
Nanos noticedAfter(Nanos period) {
  Heartbeat heart{period};
  Nanos now = 5s;
  while (heart.beats(7, now)) now += 20ms;
  return now - 5s;
}

TEST(Heartbeat, ARunningLoopCountsAsAlive) {
  Heartbeat heart{16ms};
  std::uint32_t cycles = 0;
  for (Nanos now = 0s; now < 10s; now += 20ms) EXPECT_TRUE(heart.beats(++cycles, now));
}

TEST(Heartbeat, HalfASecondWithoutACycleIsTooLong) {
  EXPECT_EQ(noticedAfter(16ms), 500ms);
  EXPECT_EQ(noticedAfter(8ms), 500ms);
}

TEST(Heartbeat, ASlowLoopGetsTenPeriods) {
  EXPECT_EQ(noticedAfter(1s), 10s);
}

TEST(Heartbeat, AShortStallIsIgnored) {
  Heartbeat heart{16ms};
  Nanos now = 0s;
  for (std::uint32_t cycles = 0; cycles < 20; ++cycles)
    for (int look = 0; look < 24; ++look, now += 20ms) EXPECT_TRUE(heart.beats(cycles, now));
}

TEST(Heartbeat, TimeInWhichTheSupervisorWasStoppedHardlyCounts) {
  Heartbeat heart{16ms};
  EXPECT_TRUE(heart.beats(1, 0s));
  EXPECT_TRUE(heart.beats(1, 3600s));
  EXPECT_TRUE(heart.beats(2, 3600s + 20ms));
}

TEST(Heartbeat, AWrappingCounterCountsAsAlive) {
  Heartbeat heart{16ms};
  EXPECT_TRUE(heart.beats(0xFFFFFFFF, 0s));
  EXPECT_TRUE(heart.beats(0, 600ms));
}

}  // namespace
}  // namespace darwinop::supervisor
