// Reactions to lost bytes, replies and supplies: rows 2xx and 3xx of the hazard table.
#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "hazards/reaction.hpp"

namespace darwinop::hazards {
namespace {

using hil::FaultKind;
using std::chrono::milliseconds;

bool writes(Bytes frame, std::uint8_t address) {
  return frame[4] == static_cast<std::uint8_t>(Instruction::kSyncWrite) && frame[5] == address;
}

TEST_F(Reaction, ASilentBoardEndsSending) {
  rig.fault(FaultKind::kStall);
  measure(isIn(State::kOffline), 8);
  const auto sent = rig.line.counters().sync_writes;
  rig.run(100);
  EXPECT_EQ(rig.line.counters().sync_writes, sent);
}

/// One joint is moved by hand while the port is unplugged and its servo restarts.
TEST_F(Reaction, AJointThatWasMovedDuringAnOutageRestartsWhereItIs) {
  rig.fault(FaultKind::kUnplug, 0, milliseconds{320});
  rig.faultAt(Joint::kNeck, FaultKind::kDead, milliseconds{200});
  bool moved = false;
  const auto again = [&] {
    if (moved) return rig.torque(Joint::kNeck);
    if (rig.torque(Joint::kNeck)) return false;
    static_cast<hil::PlainBody&>(rig.robot.body()).place(Joint::kNeck, 0.7);
    moved = true;
    return false;
  };
  measure(again, 60);
  EXPECT_TRUE(isPlaced(rig, Joint::kNeck));
  EXPECT_NEAR(radFromTicks(rig.position(Joint::kNeck)).value, 0.7, 0.05);
}

TEST_F(Reaction, ALostTorqueOffIsRepeated) {
  bool lost = false;
  rig.losing.lost = [&](Bytes frame) { return writes(frame, servo::kTorqueEnable) && !std::exchange(lost, true); };
  rig.commands.operator_releases = 1;
  measure([this] { return rig.torqueCount() == 0; }, 60);
  EXPECT_TRUE(lost);
}

TEST_F(ReactionAtStart, ALostTorqueOnIsRepeated) {
  hil::BoardOptions options;
  for (hil::ServoOptions& servo : options.servo) servo.torque_by_goal = false;  // else the next goal would do
  HazardRig switched{options};
  bool lost = false;
  switched.losing.lost = [&](Bytes frame) { return writes(frame, servo::kTorqueEnable) && !std::exchange(lost, true); };
  switched.cyclesUntil([&] { return lost; });
  measure(
      switched, [&] { return switched.torqueCount() == kJoints; }, 8);
}

TEST_F(ReactionAtStart, TorqueWaitsForAGoalThatArrives) {
  int lost = 0;
  rig.losing.lost = [&](Bytes frame) { return writes(frame, servo::kPGain) && ++lost <= 10; };
  rig.cyclesUntil([&] { return lost == 1; });
  const auto driven = [&] {
    if (lost <= 10) {
      EXPECT_EQ(rig.torqueCount(), 0U);
    }
    return rig.torqueCount() == kJoints;
  };
  measure(driven, 80);
}

TEST_F(Reaction, ASilentServoHidesTheOthersForThreeCyclesAtMost) {
  rig.faultAt(Joint::kLegLowerR, FaultKind::kDead);
  bool hidden = false;
  const auto all_others = [&] {
    const auto stale = [](const JointSensors& joint) { return !joint.motion.fresh(); };
    const auto count = std::ranges::count_if(rig.seen().joint, stale);
    hidden = hidden || count > 1;
    return hidden && count == 1;
  };
  measure(all_others, 3);
}

TEST_F(Reaction, AMissingAnswerShowsInTheAgeOfItsValues) {
  rig.faultAt(Joint::kNeck, FaultKind::kDead);
  const Rad before = rig.seen().joint[index(Joint::kNeck)].position;
  measure([this] { return !rig.seen().joint[index(Joint::kNeck)].motion.fresh(); }, 1);
  EXPECT_EQ(rig.seen().joint[index(Joint::kNeck)].position, before) << "missing is not zero";
}

TEST_F(ReactionAtStart, EveryEepromIsLockedAfterPowerOn) {
  rig.commands.session = 0;
  const auto locked = [this] {
    for (std::size_t i = 0; i < kJoints; ++i)
      if (rig.registers(static_cast<Joint>(i)).byte(servo::kLock) == 0) return false;
    return true;
  };
  measure(locked, 60);
}

TEST_F(Reaction, FiveLostAnswersOnlyDelayTheNextGoal) {
  double wanted = radFromTicks(rig.goal(Joint::kNeck)).value;
  const auto walk = [&] { rig.joint(Joint::kNeck).setGoal(Rad{wanted += 0.01}); };
  for (int i = 0; i < 20; ++i) {
    walk();
    rig.cycle();
  }
  rig.fault(FaultKind::kMiss, 5);
  int last = rig.goal(Joint::kNeck);
  bool paused = false;
  const auto goes_on = [&] {
    const int goal = rig.goal(Joint::kNeck);
    EXPECT_EQ(rig.torqueCount(), kJoints);
    EXPECT_EQ(rig.state(), State::kDriven);
    if (paused && goal != last) return true;
    if (rig.seen().board.motion.age > 0) paused = true;
    last = goal;
    walk();
    return false;
  };
  measure(goes_on, 8);
}

TEST_F(Reaction, AServoThatRestartsIsTakenOverWhereItIs) {
  rig.faultAt(Joint::kLegLowerL, FaultKind::kDead, milliseconds{30});
  bool lost = false;
  const auto again = [&] {
    lost = lost || !rig.torque(Joint::kLegLowerL);
    return lost && rig.torque(Joint::kLegLowerL);
  };
  measure(again, 120);
  EXPECT_TRUE(isPlaced(rig, Joint::kLegLowerL));
  EXPECT_NE(rig.registers(Joint::kLegLowerL).word(servo::kMovingSpeed), 0) << "0 means no speed limit";
}

TEST_F(ReactionAtStart, TorqueOfALateGoalIsTakenBack) {
  hil::BoardOptions options;
  options.servo_boot = milliseconds{10};
  HazardRig stalled{options};
  stalled.drive();
  stalled.joint(Joint::kLegLowerR).setGoal(radFromTicks(stalled.goal(Joint::kLegLowerR) - 600));
  stalled.fault(FaultKind::kStall, 0, 6 * HazardRig::kPeriod);
  stalled.faultAt(Joint::kLegLowerR, FaultKind::kDead, milliseconds{5});
  const auto knee = [&] { return stalled.robot.board().servo(Joint::kLegLowerR).state(); };
  stalled.cyclesUntil([&] { return knee().pulls() && knee().speed == 0; });
  const auto limp = [&] { return !knee().pulls(); };
  measure(stalled, limp, 9);
}

TEST_F(Reaction, ServosThatRestartTogetherAreTakenOverWhereTheyAre) {
  rig.fault(FaultKind::kDead, 0, milliseconds{30});
  bool lost = false;
  const auto again = [&] {
    lost = lost || rig.torqueCount() == 0;
    return lost && rig.torqueCount() == kJoints;
  };
  measure(again, 120);
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_TRUE(isPlaced(rig, static_cast<Joint>(i)));
    EXPECT_NE(rig.registers(static_cast<Joint>(i)).word(servo::kMovingSpeed), 0) << "0 means no speed limit";
  }
}

}  // namespace
}  // namespace darwinop::hazards
