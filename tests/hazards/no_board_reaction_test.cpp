// Reactions of servos alone on an adapter, without a board.
#include "hazards/reaction.hpp"

namespace darwinop::hazards {
namespace {

using hil::FaultKind;

hil::BoardOptions servosAlone() {
  hil::BoardOptions options;
  options.board = false;
  options.servo_boot = Nanos{200'000'000};
  return options;
}

class ReactionWithoutBoard : public ReactionAtStart {
 protected:
  ReactionWithoutBoard() : ReactionAtStart{servosAlone()} {}
  void SetUp() override { rig.drive(); }
  void staysLimp(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      rig.cycle();
      ASSERT_EQ(rig.torqueCount(), 0U) << "cycle " << i;
    }
  }
  /// Servos other than this one that were not read in the last cycle.
  [[nodiscard]] std::size_t unread(Joint but) const {
    return jointsThat([&](std::size_t i) { return i != index(but) && !rig.seen().joint[i].motion.fresh(); }).count();
  }

  static constexpr Nanos kOutage{160'000'000};  // reactions are measured from its end on
};

TEST_F(ReactionWithoutBoard, SilentServosEndSending) {
  rig.fault(FaultKind::kUnplug, 0, Nanos{1'000'000'000});
  measure([this] { return rig.state() == State::kOffline; }, 7);
}

TEST_F(ReactionWithoutBoard, ASilentFirstServoHidesTheOthersForThreeCyclesAtMost) {
  rig.faultAt(Joint::kShoulderR, FaultKind::kDead);
  rig.cycle();
  ASSERT_EQ(unread(Joint::kShoulderR), kJoints - 1) << "nothing is read after it";
  measure([this] { return unread(Joint::kShoulderR) == 0; }, 3);
}

TEST_F(ReactionWithoutBoard, AnInterruptedSupplyLeavesEveryJointLimp) {
  rig.fault(FaultKind::kDead, 0, kOutage);
  rig.run(kOutage / HazardRig::kPeriod);
  ASSERT_EQ(rig.torqueCount(), 0U);
  measure(isActive(Fault::kBoardReset), 25);
  staysLimp(300);
}

TEST_F(ReactionWithoutBoard, AnInterruptedSupplyInAKneelLeavesEveryJointLimp) {
  rig.commands.end_of_session = true;
  rig.cyclesUntil([this] { return rig.state() == State::kKneeling; });
  rig.run(10);
  rig.fault(FaultKind::kDead, 0, kOutage);
  rig.run(kOutage / HazardRig::kPeriod);
  measure([this] { return rig.state() == State::kLimp && rig.active(Fault::kBoardReset); }, 30);
  staysLimp(300);
}

TEST_F(ReactionWithoutBoard, AReleaseByAnOperatorSwitchesAllTorqueOff) {
  rig.commands.operator_releases = 1;
  measure([this] { return rig.torqueCount() == 0; }, 3);
  staysLimp(300);
}

TEST_F(ReactionWithoutBoard, AnEmptyBatteryMakesItKneel) {
  rig.fault(FaultKind::kVoltage, 9.5);
  measure([this] { return rig.state() == State::kKneeling && rig.active(Fault::kBatteryEmpty); }, 160);
}

}  // namespace
}  // namespace darwinop::hazards
