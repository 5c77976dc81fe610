// Servos alone on an adapter: the loop on the virtual servos, without anything that answers with the board's id.
#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <chrono>

#include "safety/fault_book.hpp"
#include "safety/wire_rig.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using Joints = std::bitset<kJoints>;

hil::BoardOptions servosAlone(Nanos boot = 200ms) {
  hil::BoardOptions options = bootsIn(boot);
  options.board = false;
  return options;
}

const Joints kAll = Joints{}.set();

Joints without(std::initializer_list<Joint> joints) {
  Joints rest = kAll;
  for (const Joint joint : joints) rest.reset(index(joint));
  return rest;
}

Joints ofChain(Chain chain) {
  return jointsThat([&](std::size_t i) { return kJointTable[i].chain == chain; });
}

struct WithoutBoard : ::testing::Test {
  /// Drives every joint, each at its goal.
  void drive() {
    rig.run(100);
    ASSERT_EQ(rig.state(), State::kDriven);
    ASSERT_EQ(stiff(), kAll);
    for (std::size_t i = 0; i < kJoints; ++i) rig.commands.joint[i].setGoal(Rad{rig.seen().joint[i].position.value});
    rig.run(60);
  }
  void cut(const Joints& joints, Nanos lasts) { rig.cutSupply(joints, rig.memory.now(), lasts); }
  void unplug(Nanos lasts) {
    hil::InjectedFault fault;
    fault.kind = hil::FaultKind::kUnplug;
    fault.at = rig.memory.now();
    fault.lasts = lasts;
    rig.robot.faults().add(fault);
  }
  /// Servos under torque, by their registers.
  [[nodiscard]] Joints stiff() const {
    return jointsThat([this](std::size_t i) {
      const hil::VirtualServo& servo = rig.robot.board().servo(static_cast<Joint>(i));
      return servo.listens(rig.robot.now()) && servo.table().byte(servo::kTorqueEnable) != 0;
    });
  }
  [[nodiscard]] bool active(Fault fault) const { return rig.seen().safety.active[safety::rowIndex(fault)]; }
  [[nodiscard]] const BoardSensors& board() const { return rig.seen().board; }

  WireRig rig{nullptr, servosAlone()};
};

TEST_F(WithoutBoard, EveryServoIsReadAndDriven) {
  drive();
  const std::uint32_t incomplete = rig.seen().link.incomplete;  // while the servos booted
  rig.commands.joint[index(Joint::kNeck)].setGoal(Rad{0.3});
  rig.run(120);
  EXPECT_NEAR(rig.seen().joint[index(Joint::kNeck)].position.value, 0.3, 0.01);
  for (const JointSensors& joint : rig.seen().joint) EXPECT_TRUE(joint.motion.fresh());
  EXPECT_TRUE(rig.seen().safety.active.none());
  EXPECT_EQ(rig.seen().link.late_replies, 0U);
  EXPECT_EQ(rig.seen().link.incomplete, incomplete);
}

TEST_F(WithoutBoard, NothingOfTheBoardIsEverReceived) {
  drive();
  EXPECT_TRUE(board().absent);
  EXPECT_FALSE(board().motion.ever());
  EXPECT_FALSE(board().voltage.known());
  for (const RadPerSec& axis : board().gyro) EXPECT_FALSE(axis.known());
  for (const MeterPerSec2& axis : board().accelerometer) EXPECT_FALSE(axis.known());
  EXPECT_TRUE(rig.seen().bus.fresh());
}

TEST_F(WithoutBoard, EveryEepromIsLocked) {
  drive();
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_EQ(rig.robot.board().servo(static_cast<Joint>(i)).table().byte(servo::kLock), 1) << i;
}

TEST_F(WithoutBoard, EveryEepromIsLockedAgainAfterAnInterruptedSupply) {
  drive();
  cut(kAll, 500ms);
  bool was_open = false;
  for (int i = 0; i < 250; ++i) {
    rig.cycle();
    was_open = was_open || rig.robot.board().servo(Joint::kNeck).table().byte(servo::kLock) == 0;
  }
  EXPECT_TRUE(was_open) << "a servo that starts is not locked";
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_EQ(rig.robot.board().servo(static_cast<Joint>(i)).table().byte(servo::kLock), 1) << i;
}

class SilentServo : public WithoutBoard, public ::testing::WithParamInterface<Joint> {};

TEST_P(SilentServo, OnlyCostsTheOthersMoments) {
  drive();
  cut(Joints{}.set(index(GetParam())), 3600s);
  int missed = 0;
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    const Joints silent = jointsThat([this](std::size_t j) { return !rig.seen().joint[j].motion.fresh(); });
    missed += (silent & without({GetParam()})).any() ? 1 : 0;
    ASSERT_EQ(rig.state(), State::kDriven) << i;
  }
  EXPECT_LE(missed, 3);
  EXPECT_TRUE(active(Fault::kServoSilent));
  EXPECT_EQ(stiff(), without({GetParam()}));
  EXPECT_FALSE(active(Fault::kBoardReset));
}
INSTANTIATE_TEST_SUITE_P(OfAnyChain, SilentServo,
                         ::testing::Values(Joint::kShoulderR, Joint::kShoulderL, Joint::kHead, Joint::kLegLowerL));

TEST_F(WithoutBoard, BothArmsSilentStillLeaveTheLegsDriven) {
  drive();
  const Joints arms = ofChain(row(Joint::kShoulderR).chain) | ofChain(row(Joint::kShoulderL).chain);
  cut(arms, 3600s);
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.state(), State::kDriven) << i;
  }
  EXPECT_EQ(stiff(), kAll & ~arms);
}

TEST_F(WithoutBoard, AnInterruptedSupplyLeavesEveryJointLimpUntilAPersonActs) {
  drive();
  cut(kAll, 1s);
  rig.run(30);
  EXPECT_EQ(rig.state(), State::kOffline);
  for (int i = 0; i < 400; ++i) {
    rig.cycle();
    ASSERT_TRUE(stiff().none()) << i;
  }
  EXPECT_TRUE(active(Fault::kBoardReset));
  EXPECT_EQ(rig.state(), State::kLimp);
  ++rig.commands.session;
  rig.run(100);
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_EQ(stiff(), kAll);
}

/// Of the outage, and of a servo's start.
class Outage : public ::testing::TestWithParam<std::pair<Nanos, Nanos>> {};

TEST_P(Outage, NoServoGetsTorqueAfterItBeforeAPersonActs) {
  WireRig rig{nullptr, servosAlone(GetParam().second)};
  rig.run(120);
  ASSERT_EQ(rig.state(), State::kDriven);
  rig.cutSupply(kAll, rig.memory.now() + 3ms, GetParam().first);
  rig.run(1);
  for (int i = 0; i < 400; ++i) {
    rig.cycle();
    for (std::size_t j = 0; j < kJoints; ++j) {
      const hil::VirtualServo& servo = rig.robot.board().servo(static_cast<Joint>(j));
      ASSERT_FALSE(servo.listens(rig.robot.now()) && servo.table().byte(servo::kTorqueEnable) != 0) << i;
    }
  }
  EXPECT_TRUE(rig.seen().safety.active[safety::rowIndex(Fault::kBoardReset)]);
}
INSTANTIATE_TEST_SUITE_P(WithoutBoard, Outage,
                         ::testing::Values(std::pair{20ms, 0ms}, std::pair{48ms, 0ms}, std::pair{80ms, 0ms},
                                           std::pair{100ms, 0ms}, std::pair{200ms, 0ms}, std::pair{5ms, 30ms},
                                           std::pair{5ms, 200ms}, std::pair{60ms, 200ms}, std::pair{500ms, 200ms},
                                           std::pair{2000ms, 200ms}));

TEST_F(WithoutBoard, AnInterruptionAfterTheDeathOfALoopThatHeldTheRobotIsARelease) {
  safety::Config held;
  held.held_before = true;
  for (const bool interrupted : {true, false}) {
    drive();
    // The servos of the dead loop, as the new one finds them.
    if (interrupted) cut(kAll, 300ms);
    safety::Guard next{held};
    cm730::Cm730Bus bus{rig.line, WireRig::busConfig(rig.robot.board().options())};
    runtime::Cycle loop{bus, next, WireRig::kPeriod};
    Commands asked = rig.commands;
    asked.unattended = true;
    for (int i = 0; i < 200; ++i) {
      rig.release += WireRig::kPeriod;
      rig.memory.advanceTo(rig.release);
      ++asked.sequence;
      loop.run(asked, {.release = rig.release});
      ASSERT_TRUE(!interrupted || stiff().none()) << i;
    }
    EXPECT_EQ(loop.sensors().safety.active[safety::rowIndex(Fault::kBoardReset)], interrupted);
    EXPECT_EQ(loop.sensors().safety.state, interrupted ? State::kLimp : State::kDriven);
    if (interrupted) {
      rig.run(60);  // the loop that stood still finds it too
      ++rig.commands.session;
      rig.run(1);
    }
  }
}

TEST_F(WithoutBoard, AnInterruptedSupplyInAKneelLeavesEveryJointLimp) {
  drive();
  rig.commands.end_of_session = true;
  for (int i = 0; i < 100 && rig.state() != State::kKneeling; ++i) rig.cycle();
  ASSERT_EQ(rig.state(), State::kKneeling);
  cut(kAll, 1s);
  rig.run(2);
  for (int i = 0; i < 400; ++i) {
    rig.cycle();
    ASSERT_TRUE(stiff().none()) << i;
  }
  EXPECT_TRUE(active(Fault::kBoardReset));
}

TEST_F(WithoutBoard, AnUnpluggedAdapterDoesNotCountAsAnInterruptedSupply) {
  drive();
  unplug(1s);
  rig.run(30);
  EXPECT_EQ(rig.state(), State::kOffline);
  EXPECT_EQ(stiff(), kAll) << "servos hold their last goal";
  rig.run(200);
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_FALSE(active(Fault::kBoardReset));
}

TEST_F(WithoutBoard, ALimbThatRestartsIsTakenOverGently) {
  drive();
  const Joints leg = ofChain(row(Joint::kLegLowerR).chain);
  cut(leg, 100ms);
  rig.run(200);
  EXPECT_FALSE(active(Fault::kBoardReset));
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_EQ(stiff(), kAll);
}

TEST_F(WithoutBoard, AnInterruptedSupplyOfALimpRobotReleasesNothing) {
  rig.commands = {};
  rig.run(100);
  ASSERT_EQ(rig.state(), State::kLimp);
  cut(kAll, 1s);
  rig.run(200);
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_FALSE(active(Fault::kBoardReset));
}

TEST_F(WithoutBoard, AnEmptyBatteryIsSeenInTheServosVoltages) {
  drive();
  hil::InjectedFault fault;
  fault.kind = hil::FaultKind::kVoltage;
  fault.at = rig.memory.now();
  fault.lasts = hil::InjectedFault::kForEver;
  fault.amount = 9.5;
  rig.robot.faults().add(fault);
  rig.run(160);
  EXPECT_TRUE(active(Fault::kBatteryEmpty));
  rig.run(600);
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_TRUE(stiff().none());
}

TEST_F(WithoutBoard, AnOperatorReleasesIt) {
  drive();
  rig.commands.operator_releases = 1;
  rig.run(3);
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_TRUE(stiff().none()) << i;
  }
  EXPECT_TRUE(active(Fault::kReleasedByOperator));
}

TEST_F(WithoutBoard, AServoThatReturnsAloneAfterAnOutageIsFoundWhicheverItIs) {
  for (std::size_t only = 0; only < kJoints; only += 3) {
    WireRig other{nullptr, servosAlone()};
    other.commands = {};
    other.cutSupply(kAll, Nanos{0}, 1s);
    other.run(40);
    other.cutSupply(Joints{kAll}.reset(only), Nanos{0}, 3600s);
    other.run(300);
    EXPECT_TRUE(other.seen().joint[only].motion.fresh()) << kJointTable[only].name;
    EXPECT_NE(other.state(), State::kOffline) << kJointTable[only].name;
  }
}

TEST_F(WithoutBoard, AServoThatIsSilentInTheFrontHidesNoneThatReturns) {
  const Joints others = without({Joint::kNeck});
  rig.cutSupply(others, Nanos{0}, 8s);
  rig.cutSupply(~others, 7s, 3600s);
  rig.run(430);
  EXPECT_EQ(rig.seen().silent, others) << "the bus has given up all but one";
  rig.run(200);
  for (std::size_t i = 0; i < kJoints; ++i)
    EXPECT_EQ(rig.seen().joint[i].motion.fresh(), others[i]) << kJointTable[i].name;
}

}  // namespace
}  // namespace darwinop
