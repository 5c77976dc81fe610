// How many cycles pass between a cause and the reaction that the hazard table promises, seen at the servos.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/conversions.hpp"
#include "hazards/rig.hpp"

namespace darwinop {
namespace {

using hil::FaultKind;

constexpr double kHotCelsius = 68, kOverheatCelsius = 78, kLowVolt = 10.7, kEmptyVolt = 9.5;

class Reaction : public ::testing::Test {
 protected:
  void SetUp() override { rig.drive(); }
  void measure(const std::function<bool()>& done, long at_most) {
    const long cycles = rig.cyclesUntil(done);
    EXPECT_LE(cycles, at_most);
    recordCycles(cycles);
  }
  [[nodiscard]] auto isActive(Fault fault) {
    return [this, fault] { return rig.active(fault); };
  }
  [[nodiscard]] auto isIn(State state) {
    return [this, state] { return rig.state() == state; };
  }

  HazardRig rig;
};

TEST_F(Reaction, ModeSwitchesAllTorqueOff) {
  hil::InjectedFault press;
  press.kind = FaultKind::kButton;
  press.at = rig.line.now();
  press.bits = 1;
  rig.robot.faults().add(press);
  measure([this] { return rig.torqueCount() == 0; }, 20);
}

TEST_F(Reaction, LostServoPowerLeavesEveryJointLimp) {
  rig.fault(FaultKind::kReset);
  measure(isActive(Fault::kBoardReset), 5);
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.torqueCount(), 0U) << "cycle " << i;
  }
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

TEST_F(Reaction, HotServosSlowAllJointsDown) {
  rig.fault(FaultKind::kHeat, kHotCelsius);
  const auto slow = [this] {
    return rig.registers(Joint::kNeck).word(servo::kMovingSpeed) <= registerFromSpeedLimit(RadPerSec{1.194});
  };
  measure(slow, 70);
}

TEST_F(Reaction, AnOverheatedServoMakesItKneel) {
  rig.fault(FaultKind::kHeat, kOverheatCelsius);
  measure(isIn(State::kKneeling), 70);
}

TEST_F(Reaction, AnOverloadShutdownMakesItKneel) {
  hil::InjectedFault trip;
  trip.kind = FaultKind::kErrors;
  trip.at = rig.line.now();
  trip.joints.set(index(Joint::kLegLowerR));
  trip.bits = error_bit::kOverload;
  rig.robot.faults().add(trip);
  measure(isIn(State::kKneeling), 5);
  EXPECT_FALSE(rig.torque(Joint::kLegLowerR));
}

TEST_F(Reaction, ASilentServoIsReported) {
  hil::InjectedFault unplugged;
  unplugged.kind = FaultKind::kDead;
  unplugged.at = rig.line.now();
  unplugged.joints.set(index(Joint::kHead));
  rig.robot.faults().add(unplugged);
  measure(isActive(Fault::kServoSilent), 32);
  EXPECT_EQ(rig.state(), State::kDriven);
}

TEST_F(Reaction, ASilentBoardEndsSending) {
  rig.fault(FaultKind::kStall);
  measure(isIn(State::kOffline), 8);
  const auto sent = rig.line.counters().sync_writes;
  rig.run(100);
  EXPECT_EQ(rig.line.counters().sync_writes, sent);
}

TEST_F(Reaction, AFallIsReported) {
  rig.fault(FaultKind::kFallen);
  measure(isActive(Fault::kFell), 35);
}

TEST_F(Reaction, AStalledControllerIsHeld) {
  rig.controller_steps = false;
  measure(isIn(State::kHolding), 33);
  const int goal = rig.goal(Joint::kNeck);
  rig.commands.joint[index(Joint::kNeck)].setGoal(Rad{1.0});
  rig.run(50);
  EXPECT_EQ(rig.goal(Joint::kNeck), goal);
}

TEST_F(Reaction, AControllerThatIsGoneMakesItKneel) {
  rig.controller_steps = false;
  measure(isIn(State::kKneeling), 630);
}

TEST_F(Reaction, TheEndOfAControllerMakesItKneelAndReleaseTorque) {
  rig.commands.end_of_session = true;
  measure([this] { return rig.torqueCount() == 0; }, 400);
}

TEST_F(Reaction, AGoalThatIsNotFiniteMovesNothing) {
  const int goal = rig.goal(Joint::kNeck);
  rig.commands.joint[index(Joint::kNeck)].setGoal(Rad{std::numeric_limits<double>::quiet_NaN()});
  rig.cycle();
  recordCycles(1);
  EXPECT_EQ(rig.goal(Joint::kNeck), goal);
}

TEST_F(Reaction, AFarGoalMovesByOneStepACycle) {
  const int goal = rig.goal(Joint::kNeck);
  rig.commands.joint[index(Joint::kNeck)].setGoal(Rad{1.0});
  rig.cycle();
  recordCycles(1);
  EXPECT_LE(std::abs(rig.goal(Joint::kNeck) - goal), 12.26 * 0.016 / kRadPerTick + 1);
}

TEST_F(Reaction, AServoThatRestartsIsTakenOverWhereItIs) {
  hil::InjectedFault dropout;
  dropout.kind = FaultKind::kDead;
  dropout.at = rig.line.now();
  dropout.lasts = Nanos{30'000'000};
  dropout.joints.set(index(Joint::kLegLowerL));
  rig.robot.faults().add(dropout);
  rig.cycle();
  ASSERT_FALSE(rig.torque(Joint::kLegLowerL));
  measure([this] { return rig.torque(Joint::kLegLowerL); }, 120);
  const hil::ControlTable& knee = rig.registers(Joint::kLegLowerL);
  EXPECT_LE(std::abs(knee.word(servo::kGoalPosition) - knee.word(servo::kPresentPosition)), 9);
  EXPECT_NE(knee.word(servo::kMovingSpeed), 0) << "0 means no speed limit";
}

}  // namespace
}  // namespace darwinop
