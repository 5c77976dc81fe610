// What must be known of a servo before it is written to. A bus may answer without the torque registers.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr Joint kNeck = Joint::kNeck;

TEST(WithoutLooks, TorqueWaitsUntilTheGoalWasSeenInTheServo) {
  Rig rig;
  rig.robot[kNeck].looked_at = false;
  rig.newSession();
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.safe->torqueOn()[index(kNeck)]) << "cycle " << i;
  }
  EXPECT_TRUE(rig.robot[Joint::kHead].torque) << "the others are not kept waiting";
}

TEST(WithoutLooks, AJointThatMissedAnAnswerStaysHeldUntilItsTorqueRegistersAreRead) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  const double goal = rig.goal(kNeck);
  rig.robot[kNeck].looked_at = rig.robot[kNeck].answers = false;
  rig.cycle();
  rig.robot[kNeck].answers = true;
  rig.joint(kNeck).setGoal(Rad{goal + 0.3});
  rig.cycle();
  for (int i = 0; i < 30; ++i) {
    rig.cycle();
    ASSERT_TRUE(rig.held(kNeck)) << "cycle " << i;
    ASSERT_EQ(rig.goal(kNeck), goal) << "cycle " << i;
  }
  rig.robot[kNeck].looked_at = true;
  rig.runFor(1);
  EXPECT_NEAR(rig.goal(kNeck), goal + 0.3, 1e-9);
}

TEST(WithoutLooks, TorqueStaysOffWhereTheReadingThatFindsTheGoalReportsOverheating) {
  const auto placed = [](Rig& rig) {
    rig.newSession();
    return rig.runUntil([&] { return rig.safe && rig.driven(kNeck); });
  };
  Rig undisturbed;
  const int cycles = placed(undisturbed);
  ASSERT_GT(cycles, 1);
  Rig rig;
  rig.newSession();
  rig.run(cycles - 1);
  rig.robot[kNeck].error_bits = error_bit::kOverheat;
  rig.cycle();  // the goal is written, and read back with the error bit
  rig.robot[kNeck].error_bits = 0;
  rig.cycle();
  EXPECT_FALSE(rig.safe->torqueOn()[index(kNeck)]);
  EXPECT_TRUE(rig.safe->torqueOn()[index(Joint::kHead)]);
  rig.run(10);
  EXPECT_TRUE(rig.robot[kNeck].torque) << "one reading is only a suspicion";
}

}  // namespace
}  // namespace darwinop::safety
