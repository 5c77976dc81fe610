// Conditions that must last.
#include "safety/debounce.hpp"

#include <gtest/gtest.h>

namespace darwinop::safety {
namespace {

constexpr Nanos kTick{std::chrono::milliseconds{10}};

TEST(Debounce, TurnsOnAfterTheConditionLastedAndNotBefore) {
  Debounce d{3 * kTick, 2 * kTick};
  EXPECT_FALSE(d.update(true, false, kTick));
  EXPECT_FALSE(d.update(true, false, kTick));
  EXPECT_TRUE(d.update(true, false, kTick));
}

TEST(Debounce, AnInterruptionRestartsTheWait) {
  Debounce d{3 * kTick, 2 * kTick};
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(d.update(true, false, kTick));
    EXPECT_FALSE(d.update(true, false, kTick));
    EXPECT_FALSE(d.update(false, false, kTick));
  }
}

TEST(Debounce, StaysOnBetweenTheThresholdsAndTurnsOffWhenClearLasted) {
  Debounce d{kTick, 2 * kTick};
  EXPECT_TRUE(d.update(true, false, kTick));
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(d.update(false, false, kTick));
  EXPECT_TRUE(d.update(false, true, kTick));
  EXPECT_FALSE(d.update(false, true, kTick));
}

TEST(Confirm, OneSampleIsASuspicionTwoAreAFact) {
  Confirm c;
  EXPECT_FALSE(c.update(true, false));
  EXPECT_TRUE(c.suspected());
  EXPECT_FALSE(c.update(false, true));
  EXPECT_FALSE(c.suspected());
  EXPECT_FALSE(c.update(true, false));
  EXPECT_TRUE(c.update(true, false));
  EXPECT_FALSE(c.suspected());
}

TEST(Confirm, OneGoodSampleDoesNotClearAFact) {
  Confirm c;
  c.update(true, false);
  c.update(true, false);
  EXPECT_TRUE(c.update(false, true));
  EXPECT_TRUE(c.update(true, false));
  EXPECT_TRUE(c.update(false, true));
  EXPECT_FALSE(c.update(false, true));
}

}  // namespace
}  // namespace darwinop::safety
