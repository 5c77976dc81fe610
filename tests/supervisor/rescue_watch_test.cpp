#include "supervisor/rescue_watch.hpp"

#include <gtest/gtest.h>

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;
using Step = RescueWatch::Step;

Sensors image(std::uint64_t cycle, State state, bool stiff) {
  Sensors seen;
  seen.cycle = cycle;
  seen.safety.state = state;
  for (JointSensors& joint : seen.joint) {
    joint.motion.received();
    joint.polled.received();
    joint.torque_enabled = stiff;
  }
  return seen;
}

/// Steps until the state differs from `step`; returns the number of cycles.
std::uint64_t cyclesOf(Step step, RescueWatch& watch, std::uint64_t& cycle, State state, bool stiff) {
  const std::uint64_t from = cycle;
  while (watch.update(image(cycle, state, stiff)) == step && cycle - from < 100'000) ++cycle;
  return cycle - from;
}

TEST(RescueWatch, HoldsForASecondBeforeAnythingMoves) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  EXPECT_EQ(cyclesOf(Step::kHold, watch, cycle, State::kLimp, true), 62U);
}

TEST(RescueWatch, ALimpRobotIsAtRestWithoutACrouch) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  cyclesOf(Step::kHold, watch, cycle, State::kLimp, false);
  EXPECT_EQ(cyclesOf(Step::kCrouch, watch, cycle, State::kLimp, false), 49U);
  EXPECT_EQ(watch.update(image(cycle, State::kLimp, false)), Step::kAtRest);
}

TEST(RescueWatch, ARobotUnderTorqueIsAtRestOnlyWhenEveryServoIsLimp) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  cyclesOf(Step::kHold, watch, cycle, State::kLimp, true);
  for (; cycle < 100; ++cycle) EXPECT_EQ(watch.update(image(cycle, State::kLimp, true)), Step::kCrouch);
  for (; cycle < 200; ++cycle) EXPECT_EQ(watch.update(image(cycle, State::kKneeling, true)), Step::kCrouch);
  for (; cycle < 220; ++cycle) EXPECT_EQ(watch.update(image(cycle, State::kLimp, true)), Step::kCrouch);
  EXPECT_EQ(cyclesOf(Step::kCrouch, watch, cycle, State::kLimp, false), 49U);
}

TEST(RescueWatch, AServoThatKeepsTorqueDoesNotBlockTheRescue) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  cyclesOf(Step::kHold, watch, cycle, State::kLimp, true);
  EXPECT_NEAR(static_cast<double>(cyclesOf(Step::kCrouch, watch, cycle, State::kLimp, true)), 675, 2);
  EXPECT_EQ(watch.update(image(cycle, State::kLimp, true)), Step::kStiff);
}

TEST(RescueWatch, TimeWithoutTheBoardIsNotCounted) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  for (; cycle < 10'000; ++cycle) EXPECT_EQ(watch.update(image(cycle, State::kOffline, false)), Step::kHold);
  EXPECT_FALSE(watch.online());
  EXPECT_GE(cyclesOf(Step::kHold, watch, cycle, State::kLimp, true), 61U);
  EXPECT_TRUE(watch.online());
}

TEST(RescueWatch, ARobotOnABadCableIsNeverGivenUp) {
  RescueWatch watch{16ms, 10s};
  std::uint64_t cycle = 1;
  cyclesOf(Step::kHold, watch, cycle, State::kLimp, true);
  for (int spell = 0; spell < 20; ++spell) {
    for (int i = 0; i < 500; ++i) EXPECT_EQ(watch.update(image(++cycle, State::kKneeling, true)), Step::kCrouch);
    EXPECT_EQ(watch.update(image(++cycle, State::kOffline, true)), Step::kCrouch);
  }
  EXPECT_NEAR(static_cast<double>(cyclesOf(Step::kCrouch, watch, cycle, State::kLimp, true)), 675, 3);
}

TEST(RescueWatch, ASilentServoDoesNotDelayTheRescue) {
  Sensors seen = image(1, State::kLimp, true);
  EXPECT_TRUE(anyStiff(seen));
  for (JointSensors& joint : seen.joint) joint.motion.age = 1000;
  EXPECT_FALSE(anyStiff(seen));
}

}  // namespace
}  // namespace darwinop::supervisor
