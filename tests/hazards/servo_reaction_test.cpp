// Reactions to what a servo does or reports: rows 3xx of the hazard table.
#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "hazards/reaction.hpp"
#include "hil-mocks/servo_observer.hpp"

namespace darwinop::hazards {
namespace {

using hil::FaultKind;

constexpr double kHotCelsius = 68, kOverheatCelsius = 78, kLowVolt = 10.7, kEmptyVolt = 9.5;

TEST_F(Reaction, HotServosSlowAllJointsDown) {
  const auto speed = [this](Joint joint) { return rig.registers(joint).word(servo::kMovingSpeed); };
  const auto gentle = registerFromSpeedLimit(RadPerSec{kGentleSpeed});
  for (const Joint joint : {Joint::kNeck, Joint::kLegLowerR}) {
    rig.joint(joint).setSpeedLimit(RadPerSec{8});
    rig.joint(joint).setGoal(radFromTicks(rig.goal(joint) - 20));
  }
  rig.run(120);
  ASSERT_GT(speed(Joint::kNeck), gentle);
  ASSERT_GT(speed(Joint::kLegLowerR), gentle);
  rig.fault(FaultKind::kHeat, kHotCelsius);
  measure([&] { return speed(Joint::kNeck) <= gentle && speed(Joint::kLegLowerR) <= gentle; }, 70);
  EXPECT_EQ(rig.state(), State::kDriven) << "slower, but driven";
  const int before = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.cycle();
  EXPECT_NE(rig.goal(Joint::kNeck), before);
  EXPECT_LE(std::abs(rig.goal(Joint::kNeck) - before), kGentleSpeed * 0.016 / kRadPerTick + 1);
}

TEST_F(Reaction, AnOverheatedServoMakesItKneel) {
  rig.fault(FaultKind::kHeat, kOverheatCelsius);
  measure(isIn(State::kKneeling), 70);
}

TEST_F(Reaction, LowBatteryIsReported) {
  rig.fault(FaultKind::kVoltage, kLowVolt);
  measure(isActive(Fault::kBatteryLow), 130);
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST_F(Reaction, EmptyBatteryMakesItKneel) {
  rig.fault(FaultKind::kVoltage, kEmptyVolt);
  measure(isIn(State::kKneeling), 130);
}

TEST_F(Reaction, AnOverloadShutdownMakesItKneel) {
  rig.faultAt(Joint::kLegLowerR, FaultKind::kErrors, hil::InjectedFault::kForEver, error_bit::kOverload);
  measure(isIn(State::kKneeling), 5);
  EXPECT_FALSE(rig.torque(Joint::kLegLowerR));
}

TEST_F(Reaction, AShutdownWithoutItsErrorBitMakesItKneel) {
  rig.poke(Joint::kLegLowerR, servo::kTorqueLimit, {0, 0});
  rig.poke(Joint::kLegLowerR, servo::kTorqueEnable, {0});
  measure(isIn(State::kKneeling), 60);
  for (int i = 0; i < 50; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.robot.board().servo(Joint::kLegLowerR).state().pulls()) << "nothing switches it on again";
  }
}

TEST_F(Reaction, ASilentServoIsReported) {
  rig.faultAt(Joint::kHead, FaultKind::kDead);
  measure(isActive(Fault::kServoSilent), 32);
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST_F(Reaction, OneDamagedErrorByteLeavesAJointOutForMoments) {
  rig.losing.damageNext(Joint::kNeck, error_bit::kOverload);
  const auto driven = [this] { return rig.seen().joint[index(Joint::kNeck)].driven; };
  bool left_out = false;
  const auto again = [&] {
    EXPECT_EQ(rig.state(), State::kDriven);
    left_out = left_out || !driven();
    return left_out && driven() && rig.torque(Joint::kNeck);
  };
  measure(again, 30);
}

/// Cycles from an overload shutdown, so long after a joint is blocked, to the kneel.
long cyclesToKneelUnderAStreamOfLimits(Nanos blocked_for) {
  HazardRig rig;
  rig.drive();
  hil::InjectedFault jam;
  jam.kind = FaultKind::kJam;
  jam.at = rig.line.now();
  jam.amount = std::chrono::duration<double>(blocked_for).count();
  jam.joints.set(index(Joint::kLegLowerR));
  rig.robot.faults().add(jam);
  double limit = 2;
  const auto stream = [&] {
    for (JointCommand& joint : rig.commands.joint) joint.setTorqueLimit(NewtonMeter{limit});
    limit = limit > 2 ? 1.9 : 2.1;
  };
  rig.cyclesUntil([&] {
    stream();
    return !rig.torque(Joint::kLegLowerR);
  });
  return rig.cyclesUntil([&] {
    stream();
    EXPECT_FALSE(rig.torque(Joint::kLegLowerR)) << "switched on again";
    return rig.state() == State::kKneeling;
  });
}

TEST_F(ReactionAtStart, AStreamOfTorqueLimitsHidesNoShutdown) {
  long longest = 0;
  for (auto phase = std::chrono::milliseconds{0}; phase < HazardRig::kPeriod; phase += std::chrono::milliseconds{2})
    longest = std::max(longest, cyclesToKneelUnderAStreamOfLimits(std::chrono::milliseconds{500} + phase));
  record(longest, 30);
}

/// Its encoder reports one position whatever it does.
class StuckBody final : public hil::PlainBody {
 public:
  void step(Nanos dt, const Drives& drives) noexcept override {
    PlainBody::step(dt, drives);
    place(Joint::kNeck, 0.1);
  }
};

TEST_F(ReactionAtStart, AnEncoderThatIsStuckIsReported) {
  HazardRig stuck{{}, std::make_unique<StuckBody>()};
  stuck.drive();
  int cycle = 0;
  const auto reported = [&] {
    const bool up = (++cycle / 40) % 2 == 0;
    stuck.joint(Joint::kNeck).setGoal(Rad{up ? 0.6 : -0.4});
    return stuck.active(Fault::kEncoderStuck);
  };
  measure(stuck, reported, 250);
}

/// It is on for less than a cycle, so that nothing shows at the end of one.
struct TripCounter final : hil::ServoObserver {
  void written(Joint, std::uint8_t, Bytes, const hil::ServoState&, const hil::ServoState&) noexcept override {}
  void changed(Joint joint, hil::ServoEvent event, const hil::ServoState&, const hil::ServoState&) noexcept override {
    if (joint == Joint::kLegLowerR && event == hil::ServoEvent::kTripped) ++trips;
  }
  int trips = 0;
};

TEST_F(ReactionAtStart, AServoThatShutsItselfOffInATakeoverIsTriedTwiceAtMost) {
  hil::InjectedFault jam;
  jam.kind = FaultKind::kJam;
  jam.amount = 0.001;  // s
  jam.joints.set(index(Joint::kLegLowerR));
  rig.robot.faults().add(jam);
  TripCounter counter;
  rig.robot.board().observe(&counter);
  measure([&] { return rig.active(Fault::kServoOverload); }, 60);
  rig.run(100);
  EXPECT_GE(counter.trips, 1);
  EXPECT_LE(counter.trips, 2);
  EXPECT_FALSE(rig.torque(Joint::kLegLowerR));
  rig.robot.board().observe(nullptr);
}

}  // namespace
}  // namespace darwinop::hazards
