// Reactions to a person and to the end of a program: rows 4xx and 5xx of the hazard table.
#include "core/conversions.hpp"
#include "hazards/reaction.hpp"

namespace darwinop::hazards {
namespace {

using hil::FaultKind;

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

TEST_F(Reaction, AReleaseByAnOperatorSwitchesAllTorqueOff) {
  rig.commands.operator_releases = 1;
  measure([this] { return rig.torqueCount() == 0; }, 3);
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.torqueCount(), 0U) << "cycle " << i;
  }
}

TEST_F(Reaction, AFallIsReported) {
  rig.fault(FaultKind::kFallen);
  measure(isActive(Fault::kFell), 35);
}

TEST_F(Reaction, ResetInAKneelLeavesTheRobotLimp) {
  rig.commands.end_of_session = true;
  rig.cyclesUntil(isIn(State::kKneeling));
  rig.run(10);
  rig.fault(FaultKind::kReset);
  measure([this] { return rig.state() == State::kLimp && rig.active(Fault::kBoardReset); }, 5);
  for (int i = 0; i < 300; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.torqueCount(), 0U) << "cycle " << i;
  }
}

hil::BoardOptions powered() {
  hil::BoardOptions options;
  options.servo_power = true;
  return options;
}

/// Torque was left on by a program that is gone.
struct LeftStiff {
  LeftStiff() {
    rig.commands.session = 0;
    rig.line.advanceTo(Nanos{1'000'000});
    rig.poke(Joint::kLegLowerR, servo::kTorqueEnable, {1});
  }
  HazardRig rig{powered()};
};

TEST_F(ReactionAtStart, AStiffRobotIsReportedStiff) {
  LeftStiff left;
  ASSERT_TRUE(left.rig.torque(Joint::kLegLowerR));
  const auto found = [&] {
    EXPECT_NE(left.rig.state(), State::kLimp);
    return left.rig.state() == State::kFoundStiff;
  };
  measure(left.rig, found, 60);
}

TEST_F(ReactionAtStart, ARobotFoundStiffIsBroughtToRestWhenTheLoopCloses) {
  LeftStiff left;
  left.rig.cyclesUntil([&] { return left.rig.state() == State::kFoundStiff; });
  left.rig.commands.session = 1;
  left.rig.commands.unattended = true;
  left.rig.commands.end_of_session = true;
  measure(
      left.rig, [&] { return left.rig.torqueCount() == 0; }, 400);
}

TEST_F(Reaction, AStalledControllerIsHeld) {
  rig.controller_steps = false;
  measure(isIn(State::kHolding), 33);
  const int goal = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.run(50);
  EXPECT_EQ(rig.goal(Joint::kNeck), goal);
}

TEST_F(Reaction, AControllerThatIsGoneMakesItKneel) {
  rig.controller_steps = false;
  measure(isIn(State::kKneeling), 630);
}

TEST_F(Reaction, AControllerThatDiedDuringAnOutageMakesItKneel) {
  rig.controller_steps = false;
  rig.fault(FaultKind::kStall, 0, std::chrono::milliseconds{500});
  bool was_offline = false;
  const auto kneels = [&] {
    was_offline = was_offline || rig.state() == State::kOffline;
    return was_offline && rig.state() == State::kKneeling;
  };
  measure(kneels, 700);
}

TEST_F(Reaction, TheEndOfAControllerMakesItKneelAndReleaseTorque) {
  rig.commands.end_of_session = true;
  measure([this] { return rig.torqueCount() == 0; }, 400);
}

}  // namespace
}  // namespace darwinop::hazards
