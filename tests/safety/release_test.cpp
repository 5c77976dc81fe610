// After a person released the robot, or it lost its power under torque, torque comes back by a person's act only.
// Judged by the torque switches of the servos, never by what the guard says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

bool anyTorque(const Rig& rig) {
  return std::ranges::any_of(rig.robot.servo, [](const FakeServo& s) { return s.torque; });
}

struct Step {
  const char* name;
  void (*run)(Rig&);
  bool with_all_pairs = true;  // of what may happen afterwards; false: twice the same only, which saves time
};

void unattendedSession(Rig& rig, bool in_place) {
  const std::uint32_t session = rig.commands.session + 1;
  const Commands before = rig.commands;
  rig.commands = {};
  rig.commands.session = session;
  rig.commands.start_where_it_is = in_place;
  rig.commands.unattended = true;
  rig.commands.operator_resets = before.operator_resets;
  rig.commands.operator_releases = before.operator_releases;
  rig.steps = true;
}

void pressFor(Rig& rig, std::uint8_t button, double seconds) {
  rig.robot.buttons = button;
  rig.runFor(seconds);
  rig.robot.buttons = 0;
  rig.run(2);
}

constexpr std::uint8_t kMode = 1, kStart = 2;

/// Where the robot is when it is released.
const std::array kWhere{
    Step{"limp", [](Rig& rig) { rig.runFor(1); }},
    Step{"found_stiff",
         [](Rig& rig) {
           for (FakeServo& servo : rig.robot.servo) servo.torque = true;
           rig.runFor(1);
         }},
    Step{"taking_over",
         [](Rig& rig) {
           rig.newSession();
           rig.run(5);
         },
         false},
    Step{"starting",
         [](Rig& rig) {
           rig.newSession();
           rig.reach(State::kStarting);
           rig.run(5);
         },
         false},
    Step{"driven", [](Rig& rig) { rig.start(); }},
    Step{"holding",
         [](Rig& rig) {
           rig.start();
           rig.steps = false;
           rig.reach(State::kHolding);
         },
         false},
    Step{"kneeling",
         [](Rig& rig) {
           rig.start();
           rig.joint(Joint::kLegLowerR).setGoal(Rad{0.3});
           rig.runFor(1);
           rig.commands.end_of_session = true;
           rig.run(10);
         }},
};

const std::array kReleases{
    Step{"mode", [](Rig& rig) { pressFor(rig, kMode, 0.35); }},
    Step{"reset",
         [](Rig& rig) {
           rig.robot.servo_power = rig.robot.power_obeys = false;
           rig.run(4);
           rig.robot.power_obeys = true;
         }},
    Step{"release_order",
         [](Rig& rig) {
           ++rig.commands.operator_releases;
           rig.run(2);
         }},
    Step{"battery_empty",
         [](Rig& rig) {
           rig.robot.volt = 9.5;
           rig.runFor(2.1);
           rig.reach(State::kLimp);
           rig.robot.volt = 12;
           rig.runFor(2.1);
         }},
    Step{"overheat",
         [](Rig& rig) {
           rig.robot[Joint::kNeck].celsius = 76;
           rig.runFor(1);
           rig.reach(State::kLimp);
           rig.robot[Joint::kNeck].celsius = 40;
           rig.runFor(1);
         }},
};

/// What programs and faults may do afterwards.
const std::array kAfterwards{
    Step{"crash and restart", [](Rig& rig) { unattendedSession(rig, false); }},
    Step{"holder", [](Rig& rig) { unattendedSession(rig, true); }},
    Step{"end of session", [](Rig& rig) { rig.commands.end_of_session = true; }},
    Step{"end of a new session",
         [](Rig& rig) {
           unattendedSession(rig, true);
           rig.commands.end_of_session = true;
         }},
    Step{"kill -9",
         [](Rig& rig) {
           rig.steps = false;
           rig.runFor(1.1);
         }},
    Step{"a reset by a program",
         [](Rig& rig) {
           unattendedSession(rig, false);
           rig.cycle();
           ++rig.commands.fault_resets;
         }},
    Step{"a lost link",
         [](Rig& rig) {
           rig.robot.board_answers = false;
           rig.runFor(0.7);
           rig.robot.board_answers = true;
         }},
    Step{"a dip of the supply", [](Rig& rig) { rig.robot.servo_power = false; }},
    Step{"a touch of START", [](Rig& rig) { pressFor(rig, kStart, 0.1); }},
};

class AfterARelease : public ::testing::TestWithParam<Step> {};

TEST_P(AfterARelease, NoSequenceOfTwoProgramActsBringsTorqueBackAndAPersonDoes) {
  for (const Step& state : kWhere) {
    // Nobody drives and no joint is held: a loss of power releases nothing.
    if (std::string{state.name} == "limp" && std::string{GetParam().name} == "reset") continue;
    for (const Step& first : kAfterwards) {
      for (const Step& second : kAfterwards) {
        if (!state.with_all_pairs && first.run != second.run) continue;
        SCOPED_TRACE(std::string{state.name} + ", then " + first.name + ", then " + second.name);
        Config config;
        config.stall_ms = 200;
        config.gone_s = 1;
        config.gentle_speed = 3;  // the property does not depend on it
        Rig rig{config};
        rig.robot.goal_write_switches_on = true;
        state.run(rig);
        GetParam().run(rig);
        ASSERT_FALSE(anyTorque(rig));
        for (const Step& step : {first, second}) {
          step.run(rig);
          ASSERT_FALSE(anyTorque(rig));
          for (int i = 0; i < 40; ++i) {
            rig.cycle();
            ASSERT_FALSE(anyTorque(rig)) << "cycle " << i << " after " << step.name;
          }
        }
        if (first.run != second.run) continue;
        rig.runFor(0.5);
        pressFor(rig, kStart, 0.35);
        EXPECT_EQ(latchedFault(rig.report().active), Fault::kNone);
        unattendedSession(rig, false);
        EXPECT_TRUE(rig.reach(State::kDriven));
        EXPECT_TRUE(anyTorque(rig));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(By, AfterARelease, ::testing::ValuesIn(kReleases),
                         [](const auto& release) { return std::string{release.param.name}; });

TEST(Release, ASessionThatAPersonStartsClearsTheFaultAsEver) {
  for (const Step& release : kReleases) {
    SCOPED_TRACE(release.name);
    Rig rig;
    rig.start();
    release.run(rig);
    rig.run(20);
    ASSERT_TRUE(rig.report().controller_must_end);
    rig.newSession();
    EXPECT_TRUE(rig.reach(State::kDriven));
    EXPECT_FALSE(rig.report().controller_must_end);
  }
}

TEST(Release, AnUnattendedSessionDrivesARobotThatNobodyReleased) {
  Rig rig;
  unattendedSession(rig, false);
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(Release, AnOperatorsResetIsObeyedAlthoughNobodyHasEverDriven) {
  Rig rig;
  rig.runFor(1);
  pressFor(rig, kMode, 0.35);
  ASSERT_TRUE(rig.active(Fault::kReleasedByButton));
  ++rig.commands.operator_resets;
  rig.cycle();
  EXPECT_FALSE(rig.active(Fault::kReleasedByButton));
}

TEST(Release, AnOperatorsReleaseEndsTheSessionForGood) {
  Rig rig;
  rig.start();
  ++rig.commands.operator_releases;
  rig.cycle();
  EXPECT_TRUE(rig.active(Fault::kReleasedByOperator));
  EXPECT_TRUE(rig.report().controller_must_end);
  ASSERT_FALSE(anyTorque(rig));
  ++rig.commands.operator_resets;
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_FALSE(anyTorque(rig)) << "it steps on, and is not obeyed";
  }
  rig.newSession();
  EXPECT_TRUE(rig.reach(State::kDriven));
}

// A daemon's first cycle: the release is from before its start, and a controller has attached since.
TEST(Release, ASessionThatBeganAfterItIsNotEndedByIt) {
  Rig started_by_person, restarted;
  started_by_person.commands.operator_releases = restarted.commands.operator_releases = 1;
  started_by_person.newSession();
  EXPECT_TRUE(started_by_person.reach(State::kDriven));
  unattendedSession(restarted, false);
  restarted.runFor(2);
  EXPECT_TRUE(restarted.active(Fault::kReleasedByOperator)) << "no person has acted";
  EXPECT_FALSE(anyTorque(restarted));
}

TEST(Start, APressThatBeganBeforeTheReleaseCountsForNothing) {
  Rig rig;
  rig.start();
  rig.robot.buttons = kStart;
  rig.runFor(1);
  rig.robot.buttons = kStart | kMode;
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.robot.buttons = kStart;
  rig.runFor(2);
  EXPECT_TRUE(rig.active(Fault::kReleasedByButton));
  rig.robot.buttons = 0;
  rig.run(2);
  pressFor(rig, kStart, 0.35);
  EXPECT_FALSE(rig.active(Fault::kReleasedByButton));
}

TEST(Start, ItDoesNothingWhileTheRobotStillKneels) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kLegLowerR).setGoal(Rad{0.3});
  rig.runFor(1);
  rig.robot.volt = 9.5;
  ASSERT_TRUE(rig.reach(State::kKneeling));
  rig.robot.volt = 12;
  pressFor(rig, kStart, 0.5);
  EXPECT_TRUE(rig.active(Fault::kBatteryEmpty));
}

TEST(Start, ItIsTheControllersAsLongAsNothingWaitsForAPerson) {
  Rig rig;
  rig.start();
  pressFor(rig, kStart, 2);
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Start, ItWorksAfterALossOfPowerAlsoWhenModeBelongsToTheController) {
  Config config;
  config.release_button = ReleaseButton::kNone;
  Rig rig{config};
  rig.start();
  kReleases[1].run(rig);
  rig.runFor(1);
  ASSERT_TRUE(rig.active(Fault::kBoardReset));
  pressFor(rig, kStart, 0.35);
  EXPECT_FALSE(rig.active(Fault::kBoardReset));
}

TEST(Power, LostWhileNobodyDrivesIsAReportAndASessionDrives) {
  Rig rig;
  rig.runFor(1);
  kReleases[1].run(rig);
  EXPECT_TRUE(rig.active(Fault::kServoPowerOff));
  rig.runFor(1);
  EXPECT_TRUE(rig.report().active.none());
  EXPECT_TRUE(rig.robot.servo_power);
  unattendedSession(rig, false);
  EXPECT_TRUE(rig.reach(State::kDriven));
}

TEST(Power, IsSwitchedOnAgainThreeTimesInAMinuteThenOnlyAfterAPerson) {
  Rig rig;
  rig.runFor(1);
  const auto dips = [&] {
    rig.robot.servo_power = false;
    rig.runFor(1);
    return rig.robot.servo_power;
  };
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(dips()) << i;
  EXPECT_FALSE(dips());
  rig.runFor(120);
  EXPECT_FALSE(rig.robot.servo_power) << "not after a minute either";
  EXPECT_TRUE(rig.active(Fault::kServoPowerOff));
  pressFor(rig, kStart, 0.35);
  rig.runFor(0.2);
  EXPECT_TRUE(rig.robot.servo_power);
  for (int i = 0; i < 12; ++i) {
    rig.runFor(25);
    EXPECT_TRUE(dips()) << "seldom enough";
  }
}

TEST(Power, OfARobotThatLosesLinkAndPowerTogetherCountsAsLostUnderTorque) {
  Rig rig;
  rig.start();
  rig.robot.board_answers = rig.robot.servo_power = false;
  rig.runFor(1);
  rig.robot.board_answers = true;
  rig.robot.power_obeys = false;
  rig.run(5);
  rig.robot.power_obeys = true;
  EXPECT_TRUE(rig.active(Fault::kBoardReset));
  rig.runFor(2);
  EXPECT_FALSE(anyTorque(rig));
}

}  // namespace
}  // namespace darwinop::safety
