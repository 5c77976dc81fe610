// Lost answers of the board: a few are ridden through without a takeover, more are a lost link.
#include <gtest/gtest.h>

#include <cmath>

#include "safety/wire_rig.hpp"

namespace darwinop {
namespace {

constexpr std::size_t kWalkingKnee = index(Joint::kLegLowerR);

struct WalkingKnee : WireRig {
  WalkingKnee() {
    for (int i = 0; i < 400; ++i) step();
  }
  void step() {
    const double middle = radFromTicks((kJointTable[kWalkingKnee].low + kJointTable[kWalkingKnee].high) / 2).value;
    commands.joint[kWalkingKnee].setGoal(Rad{middle + 0.4 * std::sin(2 * kPi * 0.016 * steps++)});
    cycle();
  }
  [[nodiscard]] double behind() const {
    return std::abs(seen().joint[kWalkingKnee].commanded.value - commands.joint[kWalkingKnee].goal.value);
  }
  int steps = 0;
};

class LostBoardAnswers : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(BoardMiss, LostBoardAnswers, ::testing::Range(1, 6));

TEST_P(LostBoardAnswers, UpToFiveAreRiddenThroughWithoutATakeover) {
  WalkingKnee robot;
  ASSERT_EQ(robot.state(), State::kDriven);
  robot.line.loses_answers = true;
  for (int i = 0; i < GetParam(); ++i) {
    robot.step();
    ASSERT_TRUE(robot.allDriven());
  }
  robot.line.loses_answers = false;
  for (int i = 0; i < 60; ++i) {
    robot.step();
    ASSERT_EQ(robot.state(), State::kDriven) << "cycle " << i;
    ASSERT_TRUE(robot.allDriven()) << "no joint starts again, cycle " << i;
    ASSERT_FALSE(robot.seen().safety.active[0]) << "bus_silent";
    if (i > 3) {
      ASSERT_LT(robot.behind(), 0.01) << "the knee has caught up, cycle " << i;
    }
  }
}

TEST_P(LostBoardAnswers, RepeatedEveryTenCyclesStillAllowDriving) {
  WalkingKnee robot;
  for (int i = 0; i < 300; ++i) {
    robot.line.loses_answers = i % 10 < GetParam();
    robot.step();
    ASSERT_EQ(robot.state(), State::kDriven) << "cycle " << i;
    ASSERT_TRUE(robot.allDriven()) << "cycle " << i;
  }
}

TEST(BoardMiss, SixAreALostLink) {
  WalkingKnee robot;
  robot.line.loses_answers = true;
  for (int i = 0; i < 7; ++i) robot.step();
  EXPECT_EQ(robot.state(), State::kOffline);
}

TEST(BoardMiss, AServoThatRestartsWhileTheBoardIsSilentIsPlacedAgain) {
  for (int start = 0; start < 4; ++start) {
    WireRig robot{nullptr, bootsIn(std::chrono::milliseconds{20})};
    robot.run(300);
    ASSERT_EQ(robot.state(), State::kDriven);
    robot.line.loses_answers = true;
    robot.cutSupply(std::bitset<kJoints>{}.set(kWalkingKnee), robot.release + std::chrono::milliseconds{16 * start + 7},
                    std::chrono::milliseconds{5});
    robot.run(4);
    robot.line.loses_answers = false;
    robot.run(2);
    EXPECT_FALSE(robot.seen().joint[kWalkingKnee].driven) << "no goal until it is placed";
    EXPECT_TRUE(robot.seen().joint[0].driven);
    robot.run(20);
    EXPECT_TRUE(robot.allDriven());
    EXPECT_GT(robot.robot.board().servo(Joint::kLegLowerR).table().word(servo::kMovingSpeed), 0);
  }
}

}  // namespace
}  // namespace darwinop
