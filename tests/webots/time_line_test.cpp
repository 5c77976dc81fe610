// Which cycle a step asks for.
#include "webots/time_line.hpp"

#include <gtest/gtest.h>

#include <array>

namespace darwinop::webots_api {
namespace {

using std::chrono::milliseconds;

TEST(TimeLine, AStepOfOnePeriodIsOneCycle) {
  TimeLine line{milliseconds{16}, 100};
  for (std::uint64_t i = 1; i <= 1000; ++i) EXPECT_EQ(line.advance(milliseconds{16}), 100 + i);
}

TEST(TimeLine, AStepIsRoundedUpToAWholeCycle) {
  TimeLine line{milliseconds{16}, 0};
  EXPECT_EQ(line.advance(milliseconds{17}), 2u);
}

TEST(TimeLine, TheRemainderIsCarriedOverSoThatTheMeanIsExact) {
  TimeLine line{milliseconds{16}, 0};
  std::uint64_t cycle = 0;
  for (int i = 0; i < 1600; ++i) cycle = line.advance(milliseconds{20});
  EXPECT_EQ(cycle, 2000u);
}

TEST(TimeLine, StepsShorterThanThePeriodShareCycles) {
  TimeLine line{milliseconds{16}, 0};
  const std::array<std::uint64_t, 6> expected{1, 1, 1, 1, 2, 2};
  for (const std::uint64_t cycle : expected) EXPECT_EQ(line.advance(milliseconds{4}), cycle);
}

TEST(TimeLine, AZeroStepAsksForTheSameCycleAgain) {
  TimeLine line{milliseconds{16}, 7};
  EXPECT_EQ(line.advance(milliseconds{0}), 7u);
}

TEST(TimeLine, ARestartForgetsTheRemainder) {
  TimeLine line{milliseconds{16}, 0};
  EXPECT_EQ(line.advance(milliseconds{20}), 2u);
  line.restartAt(5);
  EXPECT_EQ(line.advance(milliseconds{16}), 6u);
}

}  // namespace
}  // namespace darwinop::webots_api
