// A board that stalls carries out what it was sent only when the stall is over, and by then a servo may have restarted.
// A goal that is on its way cannot be called back, and the servo cannot know that it is old: what has to hold is that
// there is one such goal at most, and that the torque it switches on is taken back at once.
#include <gtest/gtest.h>

#include <cmath>

#include "safety/wire_rig.hpp"
#include "support/falling_body.hpp"

namespace darwinop {
namespace {

using std::chrono::milliseconds;

constexpr Joint kKnee = Joint::kLegLowerR;

struct StalledBoard {
  StalledBoard() : StalledBoard{std::make_unique<FallingBody>()} {}

  FallingBody& body;
  WireRig rig;
  int without_limit = 0;  // cycles that the knee ended under torque without a speed limit

  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      const double phase = static_cast<double>(rig.seen().cycle) * 0.1;
      rig.commands.joint[index(kKnee)].setGoal(Rad{1.6 + 0.2 * std::sin(phase)});
      rig.cycle();
      const hil::ServoState servo = state();
      without_limit += servo.pulls() && servo.speed == 0 ? 1 : 0;
    }
  }
  /// The board hangs from before the next write on; meanwhile the knee's servo restarts.
  void stall(int cycles) {
    body.arm();
    hil::InjectedFault fault;
    fault.kind = hil::FaultKind::kStall;
    fault.at = rig.memory.now();
    fault.lasts = cycles * WireRig::kPeriod;
    rig.robot.faults().add(fault);
    rig.cutSupply(std::bitset<kJoints>{}.set(index(kKnee)), rig.memory.now() + milliseconds{2}, milliseconds{5});
  }
  [[nodiscard]] hil::ServoState state() const { return rig.robot.board().servo(kKnee).state(); }

 private:
  explicit StalledBoard(std::unique_ptr<FallingBody> made)
      : body{*made}, rig{std::move(made), bootsIn(milliseconds{10})} {}
};

class LateGoal : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(BoardStall, LateGoal, ::testing::Values(2, 3, 4, 5, 6, 8, 15, 30));

TEST_P(LateGoal, TorqueThatALateGoalSwitchedOnAtARestartedServoIsTakenBackAtOnce) {
  StalledBoard board;
  board.run(400);
  ASSERT_EQ(board.rig.state(), State::kDriven);
  board.stall(GetParam());
  board.run(GetParam() + 200);
  ASSERT_EQ(board.body.torqueOn().size(), 2u) << "the late goal, and the takeover";
  EXPECT_EQ(board.body.torqueOn()[1].joint, kKnee);
  EXPECT_LT(std::abs(board.body.torqueOn()[1].off), 9 * kRadPerTick);
  EXPECT_LT(board.body.torqueOn()[1].speed_limit, 1.3);
  // A board that is silent for longer than is ridden through is asked in one cycle of eight.
  EXPECT_LE(board.without_limit, GetParam() <= 4 ? 2 : 9);
  EXPECT_TRUE(board.state().pulls());
  EXPECT_TRUE(board.rig.allDriven());
  EXPECT_TRUE(board.rig.seen().safety.active.none());
}

TEST(LateGoal, OneIsOnItsWayAtMostAndItIsOneStepAwayFromTheLast) {
  for (int stall = 2; stall < 12; ++stall) {
    StalledBoard board;
    board.run(400);
    const int before = board.state().goal;
    const auto sent = board.rig.memory.counters().sync_writes;
    board.stall(stall);
    board.run(stall);
    EXPECT_EQ(board.rig.memory.counters().sync_writes - sent, 1u) << stall;
    const auto executed = board.rig.robot.board().counters().sync_writes;
    for (int i = 0; i < 20 && board.rig.robot.board().counters().sync_writes == executed; ++i) board.run(1);
    const double step = board.rig.config.max_joint_speed * 0.016 / kRadPerTick;
    EXPECT_LE(std::abs(board.state().goal - before), step + 1) << stall;
  }
}

}  // namespace
}  // namespace darwinop
