// What must be known of a servo before it is written to. A bus may answer without the torque registers.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr Joint kUnseen = Joint::kNeck;

TEST(WithoutPolls, TorqueWaitsUntilTheGoalWasSeenInTheServo) {
  Rig rig;
  rig.robot[kUnseen].polled = false;
  rig.newSession();
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.safe->torqueOn()[index(kUnseen)]) << "cycle " << i;
  }
  EXPECT_TRUE(rig.robot[Joint::kHead].torque) << "the others are not kept waiting";
}

TEST(WithoutPolls, AJointThatMissedAnAnswerIsSkippedUntilItsTorqueRegistersAreRead) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  const double goal = rig.goal(kUnseen);
  rig.robot[kUnseen].polled = rig.robot[kUnseen].answers = false;
  rig.cycle();
  rig.robot[kUnseen].answers = true;
  rig.joint(kUnseen).setGoal(Rad{goal + 0.3});
  rig.cycle();
  for (int i = 0; i < 30; ++i) {
    rig.cycle();
    ASSERT_TRUE(rig.skipped(kUnseen)) << "cycle " << i;
    ASSERT_EQ(rig.goal(kUnseen), goal) << "cycle " << i;
  }
  rig.robot[kUnseen].polled = true;
  rig.runFor(1);
  EXPECT_NEAR(rig.goal(kUnseen), goal + 0.3, 1e-9);
}

TEST(WithoutPolls, TorqueStaysOffWhereTheReadingThatFindsTheGoalReportsOverheating) {
  const auto placed = [](Rig& rig) {
    rig.newSession();
    return rig.runUntil([&] { return rig.safe && rig.driven(kUnseen); });
  };
  Rig undisturbed;
  const int cycles = placed(undisturbed);
  ASSERT_GT(cycles, 1);
  Rig rig;
  rig.newSession();
  rig.run(cycles - 1);
  rig.robot[kUnseen].error_bits = error_bit::kOverheat;
  rig.cycle();  // the goal is written, and read back with the error bit
  rig.robot[kUnseen].error_bits = 0;
  rig.cycle();
  EXPECT_FALSE(rig.safe->torqueOn()[index(kUnseen)]);
  EXPECT_TRUE(rig.safe->torqueOn()[index(Joint::kHead)]);
  rig.run(10);
  EXPECT_TRUE(rig.robot[kUnseen].torque) << "one reading is only a suspicion";
}

}  // namespace
}  // namespace darwinop::safety
