// Every row of the fault table: what raises it, how long that must last, what the robot does, when it is over.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr std::size_t kSome = index(Joint::kFootR);

/// A controller that sends the joint to and fro, a second each way.
void swing(Rig& rig) {
  const double middle = radFromTicks(kJointTable[kSome].start).value;
  rig.commands.joint[kSome].setGoal(Rad{middle + (rig.robot.seen.cycle / 62 % 2 == 0 ? 0.3 : -0.3)});
}

/// One fault: how to cause it, how to take the cause away, and how long either must last (upper bounds, s).
struct Case {
  Fault fault;
  void (*cause)(Rig&);
  void (*cure)(Rig&);
  double not_before, not_after, over_after;
  State state;         // while the cause lasts and all motion is over
  std::uint8_t servo;  // named in the report
  bool latched;        // stays until a person acts
};

const std::array kCases{
    Case{Fault::kBusSilent, [](Rig& r) { r.robot.board_answers = false; }, [](Rig& r) { r.robot.board_answers = true; },
         0.08, 0.13, 0.05, State::kOffline, 0, false},
    Case{Fault::kBoardReset, [](Rig& r) { r.robot.servo_power = r.robot.power_obeys = false; },
         [](Rig& r) { r.robot.power_obeys = true; }, 0.03, 0.06, 0.1, State::kLimp, 0, true},
    Case{Fault::kServoPowerOff, [](Rig& r) { r.robot.servo_power = r.robot.power_obeys = false; },
         [](Rig& r) { r.robot.power_obeys = true; }, 0.03, 0.06, 0.1, State::kLimp, 0, false},
    Case{Fault::kServoSilent, [](Rig& r) { r.robot.servo[kSome].answers = false; },
         [](Rig& r) { r.robot.servo[kSome].answers = true; }, 0.5, 0.55, 0.05, State::kDriven, 17, false},
    Case{Fault::kBatteryLow, [](Rig& r) { r.robot.volt = 10.9; }, [](Rig& r) { r.robot.volt = 11.4; }, 2.0, 2.1, 2.1,
         State::kDriven, 0, false},
    Case{Fault::kBatteryEmpty, [](Rig& r) { r.robot.volt = 9.9; }, [](Rig& r) { r.robot.volt = 11.9; }, 2.0, 2.1, 2.1,
         State::kLimp, 0, true},
    Case{Fault::kServoHot, [](Rig& r) { r.robot.servo[kSome].celsius = 65; },
         [](Rig& r) { r.robot.servo[kSome].celsius = 60; }, 0.02, 0.7, 0.7, State::kDriven, 17, false},
    Case{Fault::kServoOverheat, [](Rig& r) { r.robot.servo[kSome].celsius = 75; },
         [](Rig& r) { r.robot.servo[kSome].celsius = 50; }, 0.02, 0.7, 0.7, State::kLimp, 17, true},
    Case{Fault::kServoOverload, [](Rig& r) { r.robot.servo[kSome].error_bits = error_bit::kOverload; },
         [](Rig& r) { r.robot.servo[kSome].error_bits = 0; }, 0.03, 0.06, 0.1, State::kLimp, 17, true},
    Case{Fault::kServoVoltage, [](Rig& r) { r.robot.servo[kSome].error_bits = error_bit::kVoltage; },
         [](Rig& r) { r.robot.servo[kSome].error_bits = 0; }, 0.1, 0.14, 1.1, State::kDriven, 17, false},
    Case{Fault::kEncoderStuck,
         [](Rig& r) {
           r.robot.servo[kSome].stuck_at = r.robot.servo[kSome].position;
           r.controller = swing;
         },
         [](Rig& r) { r.robot.servo[kSome].stuck_at.reset(); }, 1.0, 2.1, 0.05, State::kDriven, 17, false},
    Case{Fault::kFell,
         [](Rig& r) {
           r.robot.acceleration = {9.8, 0, 1};
         },
         [](Rig& r) {
           r.robot.acceleration = {1, 0, 9.8};
         },
         0.5, 0.55, 0.55, State::kDriven, 0, false},
    Case{Fault::kReleasedByButton, [](Rig& r) { r.robot.buttons = 1; }, [](Rig& r) { r.robot.buttons = 0; }, 0.25, 0.3,
         0.05, State::kLimp, 0, true},
    Case{Fault::kStartMissed,
         [](Rig& r) {
           r.robot.servo[kSome].follows = false;
           r.robot.servo[kSome].position += 0.4;
           r.newSession();
         },
         [](Rig& r) {
           r.robot.servo[kSome].follows = true;
           r.newSession();
         },
         0.5, 4, 0.5, State::kDriven, 17, false},
    Case{Fault::kReleasedByOperator, [](Rig& r) { ++r.commands.operator_releases; }, [](Rig&) {}, 0, 0.02, 0.05,
         State::kLimp, 0, true},
    Case{Fault::kControllerStalled, [](Rig& r) { r.steps = false; }, [](Rig& r) { r.steps = true; }, 0.5, 0.53, 0.05,
         State::kLimp, 0, false},
    Case{Fault::kControllerGone, [](Rig& r) { r.steps = false; },
         [](Rig& r) {
           r.steps = true;
           r.newSession();  // the one that was given up is over for good
         },
         10.0, 10.05, 0.05, State::kLimp, 0, false},
};

double until(Rig& rig, Fault fault, bool active) {
  const int cycles = rig.runUntil([&] { return rig.active(fault) == active; });
  return cycles < 0 ? 1e9 : cycles * 0.016;
}

class EveryFault : public ::testing::TestWithParam<Case> {
 protected:
  Rig rig;
  const Case& c = GetParam();
  void SetUp() override {
    rig.start();
    rig.runFor(1.5);
    ASSERT_TRUE(rig.report().active.none());
    ASSERT_EQ(rig.report().worst, Fault::kNone);
  }
};

TEST_P(EveryFault, IsRaisedAfterItsTimeAndNotBefore) {
  c.cause(rig);
  const double took = until(rig, c.fault, true);
  EXPECT_GE(took, c.not_before);
  EXPECT_LE(took, c.not_after + 0.017);
  if (rig.report().worst == c.fault) {
    EXPECT_EQ(rig.report().worst_joint, c.servo);
    EXPECT_EQ(rig.report().reaction, row(c.fault).reaction);
  }
  const bool under_torque = c.fault == Fault::kServoPowerOff;  // then it is a board_reset also
  const bool gone = c.fault == Fault::kControllerGone;
  EXPECT_EQ(rig.report().controller_must_end, c.latched || under_torque || gone);
}

TEST_P(EveryFault, LeadsToItsState) {
  c.cause(rig);
  rig.runFor(16);
  EXPECT_EQ(rig.state(), c.state) << kStateNames[static_cast<std::size_t>(rig.state())];
}

TEST_P(EveryFault, GoesAwayWithItsCauseUnlessItIsLatched) {
  c.cause(rig);
  until(rig, c.fault, true);
  c.cure(rig);
  if (c.latched) {
    rig.runFor(5);
    EXPECT_TRUE(rig.active(c.fault));
  } else {
    EXPECT_LE(until(rig, c.fault, false), c.over_after + 0.05);
  }
}

TEST_P(EveryFault, AResetClearsItOnceItsCauseHasGoneAndTheRobotIsDrivenAgain) {
  c.cause(rig);
  until(rig, c.fault, true);
  rig.runFor(12);
  c.cure(rig);
  rig.runFor(3);
  if (c.fault == Fault::kControllerStalled) rig.newSession();  // the one that was given up is over for good
  ++rig.commands.fault_resets;
  rig.cycle();
  EXPECT_FALSE(rig.active(c.fault));
  EXPECT_FALSE(rig.report().controller_must_end);
  if (c.fault == Fault::kReleasedByOperator) rig.newSession();  // so is the one that was released
  ASSERT_TRUE(rig.reach(State::kDriven));
  rig.runFor(2);
  EXPECT_TRUE(rig.safe->driven().all());
  EXPECT_TRUE(rig.report().active.none());
}

TEST_P(EveryFault, AResetDoesNotHelpWhileItsCauseIsThere) {
  c.cause(rig);
  until(rig, c.fault, true);
  rig.runFor(2);
  // An overload can be judged only under torque: it is tried for a moment, see trip_test.cpp. The other two are events:
  // once a person has reset them nothing of them is left.
  if (c.fault == Fault::kServoOverload || c.fault == Fault::kBoardReset || c.fault == Fault::kReleasedByOperator)
    return;
  for (int i = 0; i < 10; ++i) {
    ++rig.commands.fault_resets;
    rig.cycle();
    EXPECT_TRUE(rig.active(c.fault));
  }
}

std::string nameOf(const ::testing::TestParamInfo<Case>& info) {
  return std::string{row(info.param.fault).name};
}
INSTANTIATE_TEST_SUITE_P(Rows, EveryFault, ::testing::ValuesIn(kCases), nameOf);

TEST(Faults, EveryRowOfTheTableHasItsCaseHere) {
  std::set<Fault> tested;
  for (const Case& c : kCases) tested.insert(c.fault);
  EXPECT_EQ(tested.size(), kFaults);
}

}  // namespace
}  // namespace darwinop::safety
