// The loop itself stands still: a debugger, SIGSTOP, a paused virtual machine. Judged at the servo.
#include <gtest/gtest.h>

#include <chrono>
#include <tuple>

#include "safety/fault_book.hpp"
#include "safety/wire_rig.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;

hil::BoardOptions servos(bool board) {
  hil::BoardOptions options = bootsIn(200ms);
  options.board = board;
  return options;
}

/// With a board, or servos alone; the loop wakes late, or skips releases.
struct StalledLoop : ::testing::TestWithParam<std::tuple<bool, bool>> {
  void SetUp() override {
    rig.run(150);
    ASSERT_EQ(rig.state(), State::kDriven);
    ASSERT_TRUE(rig.allDriven());
  }
  void stall(Nanos lasts) { rig.stall(lasts, std::get<1>(GetParam())); }
  [[nodiscard]] hil::ServoState servo(std::size_t joint) const {
    return rig.robot.board().servo(static_cast<Joint>(joint)).state();
  }

  WireRig rig{nullptr, servos(std::get<0>(GetParam()))};
};
INSTANTIATE_TEST_SUITE_P(Stall, StalledLoop, ::testing::Combine(::testing::Bool(), ::testing::Bool()));

TEST_P(StalledLoop, AServoThatRestartedMeanwhileGetsNoTorqueWithoutASpeedLimit) {
  const auto knee = index(Joint::kLegLowerL);
  rig.cutSupply(std::bitset<kJoints>{}.set(knee), rig.memory.now(), 30ms);
  stall(400ms);
  for (int i = 0; i < 150; ++i) {
    rig.cycle();
    ASSERT_FALSE(servo(knee).pulls() && servo(knee).speed == 0) << i;
  }
  EXPECT_TRUE(rig.allDriven());
  EXPECT_TRUE(servo(knee).pulls());
}

TEST_P(StalledLoop, EveryReadingIsAsOldAsTheStall) {
  rig.cutSupply(std::bitset<kJoints>{}.set(), rig.memory.now(), 3600s);
  stall(160ms);
  rig.cycle();
  for (const JointSensors& joint : rig.seen().joint) EXPECT_EQ(joint.motion.age, 10U);
}

TEST_P(StalledLoop, AShortOneInterruptsNothing) {
  stall(112ms);
  for (int i = 0; i < 50; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kDriven) << i;
  }
  EXPECT_TRUE(rig.allDriven());
}

class StalledLoopWithoutBoard : public StalledLoop {};
INSTANTIATE_TEST_SUITE_P(Stall, StalledLoopWithoutBoard,
                         ::testing::Combine(::testing::Values(false), ::testing::Bool()));

TEST_P(StalledLoopWithoutBoard, ASupplyThatWasInterruptedMeanwhileLeavesEveryJointLimp) {
  rig.cutSupply(std::bitset<kJoints>{}.set(), rig.memory.now(), 50ms);
  stall(400ms);
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    for (std::size_t joint = 0; joint < kJoints; ++joint) ASSERT_FALSE(servo(joint).pulls()) << i;
  }
  EXPECT_TRUE(rig.seen().safety.active[safety::rowIndex(Fault::kBoardReset)]);
}

}  // namespace
}  // namespace darwinop
