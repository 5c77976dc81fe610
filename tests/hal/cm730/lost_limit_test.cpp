// Torque limits whose frames are lost: found by the poll of their register, and sent again.
#include <gtest/gtest.h>

#include "core/conversions.hpp"
#include "hal/cm730/goal_writer.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Joint kArm = Joint::kShoulderR;
constexpr NewtonMeter kBefore{2.5}, kAsked{0.3};
constexpr std::size_t kWithLimits = kFrameOverhead + 2 + kJoints * (1 + 8);

/// A writer that has sent a changed limit of the arm twice, long after all joints were taken over.
struct LostLimit : testing::Test {
  GoalWriter writer;
  SafeCommandsForTests asked = SafeCommandsForTests{}.driveAll(Rad{0});

  LostLimit() {
    (void)limitsIn(100);
    asked.drive(kArm, Rad{0}, RadPerSec{12.2}, kAsked);
    EXPECT_EQ(limitsIn(50), 2);
  }
  /// Frames with torque limits in so many cycles; the second frame of a cycle never has one.
  int limitsIn(int cycles) {
    int limits = 0;
    for (int i = 0; i < cycles; ++i) {
      limits += writer.encode(asked.commands).size() == kWithLimits || writer.limitsWentAlone() ? 1 : 0;
      (void)writer.takeSecond();
    }
    return limits;
  }
};

TEST_F(LostLimit, IsSentAgainWhenAPollFindsTheOneBefore) {
  writer.noteLimit(kArm, kBefore);
  EXPECT_EQ(limitsIn(50), 2);
}

/// The limit in the register, which has 1023 counts: 0.2996 for 0.3 N m.
const NewtonMeter kStored = torqueFromRegister(registerFromTorque(kAsked));

TEST_F(LostLimit, IsNotSentAgainOnceAPollFindsItUpToRounding) {
  writer.noteLimit(kArm, kStored);
  EXPECT_EQ(limitsIn(50), 0);
  writer.noteLimit(kArm, NewtonMeter{kStored.value + 2.5 / 1023});
  EXPECT_EQ(limitsIn(50), 2) << "a count is a difference";
}

TEST_F(LostLimit, IsNeverSentToAServoThatHasShutItselfOff) {
  writer.noteLimit(kArm, NewtonMeter{0});
  EXPECT_EQ(limitsIn(50), 0) << "it would undo the shutdown";
}

TEST_F(LostLimit, IsSentThreeTimesMoreToAServoThatDoesNotStoreIt) {
  int limits = 0;
  for (int poll = 0; poll < 10; ++poll) {
    writer.noteLimit(kArm, kBefore);
    limits += limitsIn(25);
  }
  EXPECT_EQ(limits, 3 * 2);
  writer.noteLimit(kArm, kStored);
  writer.noteLimit(kArm, kBefore);
  EXPECT_EQ(limitsIn(25), 2) << "it was stored in the meantime";
}

}  // namespace
}  // namespace darwinop::cm730
