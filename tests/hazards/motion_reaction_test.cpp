// Reactions to goals, settings and poses that a joint must not follow: rows 1xx of the hazard table.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conversions.hpp"
#include "hazards/reaction.hpp"
#include "safety/session_settings.hpp"

namespace darwinop::hazards {
namespace {

constexpr double kStepTicks = kMaxVelocity * 0.016 / kRadPerTick;  // of one cycle at full speed

/// A body with a joint that something else holds or moves.
class HeldBody final : public hil::PlainBody {
 public:
  void step(Nanos dt, const Drives& drives) noexcept override {
    PlainBody::step(dt, drives);
    if (held_at) place(Joint::kNeck, *held_at);
  }
  std::optional<double> held_at;  // rad
};

struct HeldNeck {
  HeldNeck() : HeldNeck{std::make_unique<HeldBody>()} {}
  HeldBody& body;
  HazardRig rig;

 private:
  explicit HeldNeck(std::unique_ptr<HeldBody> made) : body{*made}, rig{{}, std::move(made)} {}
};

TEST_F(ReactionAtStart, ATakeoverIgnoresTheGoalOfAnEarlierProgram) {
  rig.commands.session = 0;
  rig.run(60);
  const auto old = static_cast<std::uint16_t>(rig.position(Joint::kNeck) + 600);
  rig.poke(Joint::kNeck, servo::kGoalPosition, {lowByte(old), highByte(old)});
  rig.poke(Joint::kNeck, servo::kTorqueEnable, {0});
  rig.run(30);
  ASSERT_EQ(rig.goal(Joint::kNeck), old);
  ASSERT_EQ(rig.torqueCount(), 0U);
  rig.commands.session = 1;
  measure([this] { return rig.torque(Joint::kNeck); }, 20);
  EXPECT_TRUE(isPlaced(rig, Joint::kNeck));
}

TEST_F(ReactionAtStart, AReadingThatASecondOneContradictsBecomesNoGoal) {
  HeldNeck neck;
  neck.rig.commands.session = 0;
  neck.rig.run(60);
  const double here = neck.body.state().joint[index(Joint::kNeck)].position_rad;
  neck.rig.commands.session = 1;
  neck.body.held_at = here + 1;
  neck.rig.cycle();
  neck.body.held_at = here;
  neck.rig.cycle();
  ASSERT_FALSE(neck.rig.torque(Joint::kNeck));
  measure(
      neck.rig, [&] { return neck.rig.torque(Joint::kNeck); }, 20);
  EXPECT_TRUE(isPlaced(neck.rig, Joint::kNeck));
}

TEST_F(Reaction, AGoalOutsideTheRangeIsClampedAndCounted) {
  rig.joint(Joint::kNeck).setGoal(Rad{10});
  const auto hits = [this] { return rig.seen().safety.limit_hits[static_cast<std::size_t>(Limit::kPosition)]; };
  measure([&] { return hits() > 0; }, 1);
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_LE(rig.goal(Joint::kNeck), row(Joint::kNeck).high);
  }
  EXPECT_EQ(rig.goal(Joint::kNeck), row(Joint::kNeck).high);
}

TEST_F(Reaction, AFarGoalMovesByOneStepACycle) {
  const int goal = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  measure([&] { return rig.goal(Joint::kNeck) != goal; }, 1);
  EXPECT_LE(std::abs(rig.goal(Joint::kNeck) - goal), kStepTicks + 1);
}

TEST_F(Reaction, TheStepAfterAnOverrunIsNoLonger) {
  rig.joint(Joint::kNeck).setGoal(Rad{2.0});
  rig.run(2);
  const int goal = rig.goal(Joint::kNeck);
  rig.release += 4 * HazardRig::kPeriod;
  measure([&] { return rig.goal(Joint::kNeck) != goal; }, 1);
  EXPECT_LE(std::abs(rig.goal(Joint::kNeck) - goal), kStepTicks + 1);
}

TEST_F(Reaction, AGoalThatIsNotFiniteMovesNothing) {
  const int goal = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{std::numeric_limits<double>::quiet_NaN()});
  const auto hits = [this] { return rig.seen().safety.limit_hits[static_cast<std::size_t>(Limit::kNotFinite)]; };
  measure([&] { return hits() > 0; }, 1);
  rig.run(20);
  EXPECT_EQ(rig.goal(Joint::kNeck), goal);
}

TEST_F(Reaction, ASpeedLimitOfZeroBecomesTheLowestSpeed) {
  rig.joint(Joint::kNeck).setSpeedLimit(RadPerSec{0});
  const auto speed = [this] { return rig.registers(Joint::kNeck).word(servo::kMovingSpeed); };
  measure([&] { return speed() == 1; }, 2);
  for (int i = 0; i < 50; ++i) {
    rig.cycle();
    ASSERT_EQ(speed(), 1) << "0 means no speed limit";
  }
}

TEST_F(ReactionAtStart, TheStartMoveIsGentleWhateverTheControllerAsks) {
  HeldNeck neck;
  neck.body.place(Joint::kNeck, radFromTicks(row(Joint::kNeck).start).value + 0.8);
  neck.rig.commands.start_where_it_is = false;
  neck.rig.joint(Joint::kNeck).setSpeedLimit(RadPerSec{12});
  neck.rig.joint(Joint::kNeck).setGoal(Rad{-1});
  const auto gentle = registerFromSpeedLimit(RadPerSec{kGentleSpeed});
  const auto started = [&] {
    if (neck.rig.state() == State::kDriven) return true;
    if (neck.rig.torque(Joint::kNeck)) {
      EXPECT_LE(neck.rig.registers(Joint::kNeck).word(servo::kMovingSpeed), gentle);
    }
    return false;
  };
  measure(neck.rig, started, 150);
}

TEST_F(ReactionAtStart, AJointThatBlocksInTheStartMoveIsReported) {
  HeldNeck neck;
  neck.body.held_at = radFromTicks(row(Joint::kNeck).start).value + 0.8;
  neck.rig.commands.start_where_it_is = false;
  measure(
      neck.rig, [&] { return neck.rig.active(Fault::kStartMissed); }, 400);
  EXPECT_TRUE(neck.rig.seen().safety.missed_start[index(Joint::kNeck)]);
  EXPECT_EQ(neck.rig.state(), State::kDriven);
}

TEST_F(Reaction, StricterSettingsOfASessionHoldFromItsFirstGoalOn) {
  constexpr double kSlow = 0.5;  // rad/s
  safety::Config stricter;
  stricter.max_joint_speed = stricter.gentle_speed = kSlow;
  rig.commands.settings = safety::toSession(stricter);
  ++rig.commands.session;
  rig.joint(Joint::kNeck).setGoal(Rad{1.5});
  int before = rig.goal(Joint::kNeck);
  const auto slow = [this] {
    return rig.registers(Joint::kNeck).word(servo::kMovingSpeed) <= registerFromSpeedLimit(RadPerSec{kSlow});
  };
  measure(slow, 30);
  for (int i = 0; i < 60; ++i) {
    rig.cycle();
    ASSERT_LE(std::abs(rig.goal(Joint::kNeck) - before), kSlow * 0.016 / kRadPerTick + 1);
    before = rig.goal(Joint::kNeck);
  }
}

TEST_F(ReactionAtStart, AnErrorBitAndTwoLostRepliesInATakeoverLetNoJointJump) {
  long longest = 0;
  for (int after = 0; after < 40; ++after) {
    HazardRig one;
    one.commands.session = 0;
    one.run(60);
    one.commands.session = 1;
    one.run(after);
    const std::size_t before = one.torqueCount();
    one.losing.damageNext(Joint::kArmUpperR, error_bit::kOverload);
    one.cycle();
    one.fault(hil::FaultKind::kMiss, 2);
    const long cycles =
        1 + one.cyclesUntil([&] { return one.torqueCount() == kJoints && one.state() == State::kDriven; });
    if (before < kJoints) longest = std::max(longest, cycles);
    for (std::size_t i = 0; i < kJoints; ++i) ASSERT_TRUE(isPlaced(one, static_cast<Joint>(i))) << after;
  }
  record(longest, 60);
}

}  // namespace
}  // namespace darwinop::hazards
