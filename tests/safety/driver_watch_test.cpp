// Who drives, and are they still there?
#include "safety/driver_watch.hpp"

#include <gtest/gtest.h>

namespace darwinop::safety {
namespace {

constexpr Nanos kCycle{std::chrono::milliseconds{16}};

Commands image(std::uint32_t session, std::uint64_t sequence) {
  Commands c;
  c.session = session;
  c.sequence = sequence;
  return c;
}

TEST(DriverWatch, SessionZeroIsNobody) {
  const Config config;
  DriverWatch watch{config};
  watch.update(image(0, 5), false, kCycle);
  EXPECT_FALSE(watch.present());
  EXPECT_FALSE(watch.came());
}

TEST(DriverWatch, ASequenceThatStandsStillIsNotASignOfLife) {
  const Config config;
  DriverWatch watch{config};
  watch.update(image(1, 7), false, kCycle);
  for (int i = 0; i < 31; ++i) watch.update(image(1, 7), false, kCycle);
  EXPECT_FALSE(watch.stalled()) << "496 ms";
  watch.update(image(1, 7), false, kCycle);
  EXPECT_TRUE(watch.stalled()) << "512 ms";
}

TEST(DriverWatch, ASequenceThatRunsBackwardsIsNotASignOfLife) {
  const Config config;
  DriverWatch watch{config};
  watch.update(image(1, 1000), false, kCycle);
  for (std::uint64_t i = 0; i < 40; ++i) watch.update(image(1, 10 + i), false, kCycle);
  EXPECT_TRUE(watch.stalled());
}

TEST(DriverWatch, AnImageOfAnOldSessionIsNotASignOfLife) {
  const Config config;
  DriverWatch watch{config};
  watch.update(image(1, 1), false, kCycle);
  for (int i = 0; i < 40; ++i) watch.update(image(0, 0), false, kCycle);
  EXPECT_TRUE(watch.stalled());
  EXPECT_EQ(watch.session(), 1u);
}

TEST(DriverWatch, ARobotThatMovesByItselfExcusesSilence) {
  const Config config;
  DriverWatch watch{config};
  for (int i = 0; i < 1000; ++i) watch.update(image(1, 1), true, kCycle);
  EXPECT_FALSE(watch.stalled());
}

TEST(DriverWatch, AfterTheEndOfASessionOnlyANewOneCounts) {
  const Config config;
  DriverWatch watch{config};
  watch.update(image(1, 1), false, kCycle);
  Commands last = image(1, 2);
  last.end_of_session = true;
  watch.update(last, false, kCycle);
  EXPECT_TRUE(watch.ended());
  watch.update(image(1, 3), false, kCycle);
  EXPECT_FALSE(watch.present());
  watch.update(image(2, 0), false, kCycle);
  EXPECT_TRUE(watch.present());
  EXPECT_TRUE(watch.came());
}

TEST(DriverWatch, ResetIsAskedByAChangedCounterAndByANewSession) {
  const Config config;
  DriverWatch watch{config};
  Commands c = image(1, 1);
  c.fault_resets = 4;
  watch.update(c, false, kCycle);
  EXPECT_TRUE(watch.resetAsked()) << "new session";
  watch.update(c, false, kCycle);
  EXPECT_FALSE(watch.resetAsked());
  c.fault_resets = 5;
  watch.update(c, false, kCycle);
  EXPECT_TRUE(watch.resetAsked());
  watch.update(c, false, kCycle);
  EXPECT_FALSE(watch.resetAsked()) << "one change is one request";
}

}  // namespace
}  // namespace darwinop::safety
