// When a loop that ends may leave its robot.
#include "runtime/rest.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace darwinop::runtime {
namespace {

using std::chrono::milliseconds;

class RestTest : public testing::Test {
 protected:
  RestTest() {
    seen_.board.motion.received();
    seen_.board.servo_power = true;
    for (JointSensors& joint : seen_.joint) {
      joint.motion.received();
      joint.polled.received();
    }
  }
  /// Cycles in this state until the robot may be left, at most `most`.
  std::optional<int> cyclesIn(State state, int most = 1000) {
    seen_.safety.state = state;
    for (int cycle = 0; cycle <= most; ++cycle, ++seen_.cycle)
      if (rest_.reached(seen_)) return cycle;
    return std::nullopt;
  }

  /// Every servo is polled in this many cycles, as in runtime/torque_left.cpp.
  static constexpr int kRound = kPollRound;
  Sensors seen_;
  Rest rest_{safety::Config{}, milliseconds{16}};
};

TEST_F(RestTest, IsWhenEveryServoWasPolledAfterTorqueOff) {
  EXPECT_EQ(cyclesIn(State::kKneeling), std::nullopt);
  EXPECT_EQ(cyclesIn(State::kLimp), kRound);
}

TEST_F(RestTest, AServoWithTorqueGetsFourRoundsToLoseIt) {
  seen_.joint[index(Joint::kNeck)].torque_enabled = true;
  EXPECT_EQ(cyclesIn(State::kLimp, 2 * kRound), std::nullopt);
  seen_.joint[index(Joint::kNeck)].torque_enabled = false;
  EXPECT_EQ(cyclesIn(State::kLimp), 0);
}

TEST_F(RestTest, AServoThatKeepsItsTorqueIsGivenUp) {
  seen_.joint[index(Joint::kNeck)].torque_enabled = true;
  EXPECT_EQ(cyclesIn(State::kLimp), 4 * kRound);
}

TEST_F(RestTest, ASilentBoardIsWaitedForThreeSeconds) {
  EXPECT_EQ(cyclesIn(State::kOffline), 3000 / 16);
}

TEST_F(RestTest, AnInterruptionThatEndsIsForgotten) {
  EXPECT_EQ(cyclesIn(State::kOffline, 100), std::nullopt);
  EXPECT_EQ(cyclesIn(State::kKneeling, 10), std::nullopt);
  EXPECT_EQ(cyclesIn(State::kOffline), 3000 / 16);
}

TEST_F(RestTest, ASessionThatMovesMoreGentlyGetsMoreTime) {
  const Nanos usual = rest_.atMost(seen_);
  EXPECT_EQ(usual, Rest::atMost(safety::Config{}.gentle_speed)) << "not known yet";
  seen_.safety.gentle_speed = 0.05F;
  EXPECT_GT(rest_.atMost(seen_), std::chrono::seconds{180});
}

TEST_F(RestTest, AFaultThatSitsTheRobotDownIsNotCutOffByHold) {
  safety::Config config;
  config.on_exit = safety::OnExit::kHold;
  rest_ = Rest{config, milliseconds{16}};
  seen_.safety.reaction = Reaction::kKneel;
  EXPECT_EQ(cyclesIn(State::kDriven), std::nullopt) << "the kneel begins";
  EXPECT_EQ(cyclesIn(State::kKneeling), std::nullopt);
  seen_.safety.reaction = Reaction::kLimp;
  EXPECT_EQ(cyclesIn(State::kLimp), kRound);
}

TEST_F(RestTest, ALimpRobotIsNotLeftBeforeTheEndOfTheSessionIsTakenIn) {
  safety::Config config;
  config.on_exit = safety::OnExit::kHold;
  rest_ = Rest{config, milliseconds{16}};
  EXPECT_EQ(cyclesIn(State::kDriven), 3) << "held as it is";
}

}  // namespace
}  // namespace darwinop::runtime
