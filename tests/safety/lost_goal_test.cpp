// Writes that are lost on the wire, judged at the servo: in a takeover its torque comes on only with the goal where it
// is, and a torque limit arrives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "safety/wire_rig.hpp"
#include "support/every_case.hpp"

namespace darwinop {
namespace {

constexpr Joint kArm = Joint::kShoulderR;
constexpr double kWasAt = 1.5, kIsAt = -1.2;  // rad

/// Loses SyncWrites; what else is sent gets through.
class LossyLine final : public ByteLine {
 public:
  explicit LossyLine(ByteLine& inner) : inner_{inner} {}
  int goals_to_lose = 0;
  std::uint32_t writes_to_lose = 0;  // bit 0: the next SyncWrite, bit 1: the one after it, ...

  [[nodiscard]] Nanos now() noexcept override { return inner_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    const bool sync_write = bytes[4] == static_cast<std::uint8_t>(Instruction::kSyncWrite);
    if (sync_write && (std::exchange(writes_to_lose, writes_to_lose / 2) & 1) != 0) return LineStatus::kOk;
    const bool goals = sync_write && bytes[5] != servo::kTorqueEnable;
    if (!goals || goals_to_lose == 0) return inner_.write(bytes);
    --goals_to_lose;
    return LineStatus::kOk;
  }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    return inner_.read(into, count, deadline);
  }
  void discardInput() noexcept override { inner_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return inner_.reconnects(); }

 private:
  ByteLine& inner_;
};

/// An arm is limp and is moved by hand; its servo still has the goal of before.
struct LimpArm final : private hil::ServoObserver {
  explicit LimpArm(Nanos loop_period = WireRig::kPeriod, double is_at = kIsAt) : period{loop_period} {
    robot.board().observe(this);
    commands.session = 1;
    commands.start_where_it_is = true;
    ask(kWasAt, true);
    run(300);
    ask(kWasAt, false);
    run(50);
    body.place(kArm, is_at);
    run(50);
    fastest = furthest = 0;
  }
  void ask(double goal, bool torque) {
    commands.joint[index(kArm)] = {};
    commands.joint[index(kArm)].setGoal(Rad{goal});
    commands.joint[index(kArm)].setTorque(torque);
    commands.joint[index(kArm)].setSpeedLimit(RadPerSec{1.1});
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      release += period;
      memory.advanceTo(release);
      ++commands.sequence;
      loop.run(commands, {.release = release});
      fastest = std::max(fastest, std::abs(body.state().joint[index(kArm)].velocity_rad_s));
    }
  }
  [[nodiscard]] hil::ServoState servo() const { return robot.board().servo(kArm).state(); }

  Nanos period;
  std::unique_ptr<hil::PlainBody> made = std::make_unique<hil::PlainBody>();
  hil::PlainBody& body = *made;
  hil::VirtualRobot robot{{}, 1, std::move(made)};
  hil::MemoryLine memory{robot};
  LossyLine line{memory};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(period)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle loop{bus, guard, period};
  Commands commands{};
  Nanos release{0};
  double fastest = 0;   // rad/s
  double furthest = 0;  // rad: goal and joint when torque came on

 private:
  void written(Joint joint, std::uint8_t /*address*/, Bytes /*data*/, const hil::ServoState& before,
               const hil::ServoState& after) noexcept override {
    if (joint != kArm || before.pulls() || !after.pulls()) return;
    furthest =
        std::max(furthest, std::abs(radFromTicks(after.goal).value - body.state().joint[index(kArm)].position_rad));
  }
  void changed(Joint, hil::ServoEvent, const hil::ServoState&, const hil::ServoState&) noexcept override {}
};

class LostGoals : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(TakeOver, LostGoals, ::testing::Values(0, 1, 2, 3, 4, 7, 20));

TEST_P(LostGoals, LeaveTheJointLimpUntilOneHasArrived) {
  LimpArm arm;
  ASSERT_FALSE(arm.servo().pulls());
  ASSERT_GT(std::abs(arm.servo().goal - ticksFromRad(Rad{kIsAt})), 1000) << "the goal of before";
  arm.ask(kIsAt, true);
  arm.line.goals_to_lose = GetParam();
  arm.run(150);
  EXPECT_EQ(arm.line.goals_to_lose, 0);
  EXPECT_LT(arm.fastest, 0.3) << "asked to stay where it is";
  EXPECT_TRUE(arm.servo().pulls()) << "and held there in the end";
  EXPECT_NEAR(arm.body.state().joint[index(kArm)].position_rad, kIsAt, 0.02);
}

/// An arm that was not moved, and was driven slowly, still has the goal and the speed limit that it is taken over with:
/// that they are seen proves nothing.
TEST(LostGoals, WhicheverOfTheFirstWritesAreLostTorqueComesOnWhereTheJointIs) {
  constexpr double kElsewhere = 0.7, kNear = 9 * kRadPerTick;  // rad
  for (const double is_at : {kIsAt, kWasAt}) {
    for (std::uint32_t lost = 0; lost < 128; lost += kNextCase) {
      LimpArm arm{WireRig::kPeriod, is_at};
      arm.ask(kElsewhere, true);  // it moves off as soon as it is driven
      arm.line.writes_to_lose = lost;
      arm.run(150);
      ASSERT_LE(arm.furthest, kNear) << "lost writes, a bit each: " << lost;
      ASSERT_TRUE(arm.servo().pulls()) << lost;
      EXPECT_LT(std::abs(arm.body.state().joint[index(kArm)].position_rad - kElsewhere),
                std::abs(is_at - kElsewhere) / 2)
          << lost;
    }
  }
}

TEST(LostLimits, AreSentAgainWithinTwoPollingRounds) {
  constexpr NewtonMeter kLimit{0.3};
  LimpArm arm;
  arm.ask(kIsAt, true);
  arm.run(150);
  arm.commands.joint[index(kArm)].setTorqueLimit(kLimit);
  arm.line.writes_to_lose = 3;
  arm.run(2);
  ASSERT_EQ(arm.servo().torque_limit, kTorqueMax) << "both are lost";
  arm.run(2 * kPollRound);
  EXPECT_EQ(arm.servo().torque_limit, registerFromTorque(kLimit));
}

TEST(LostGoals, InALoopOfEightMillisecondsAllJointsAreTakenOverFourAtATime) {
  LimpArm arm{std::chrono::milliseconds{8}};
  arm.commands.session = 2;
  arm.ask(kIsAt, true);
  arm.line.goals_to_lose = 3;
  arm.run(60);
  EXPECT_LT(arm.fastest, 0.3);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_TRUE(arm.loop.sensors().joint[i].driven) << row(static_cast<Joint>(i)).name;
  EXPECT_EQ(arm.loop.sensors().safety.state, State::kDriven);
}

}  // namespace
}  // namespace darwinop
