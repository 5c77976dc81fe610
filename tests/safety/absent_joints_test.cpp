// Joints that the robot lacks, and joints that start-up has left out.
#include <gtest/gtest.h>

#include <bitset>
#include <functional>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

Config lacking(std::bitset<kJoints> Config::*kind, Joint joint) {
  Config config;
  (config.*kind).set(index(joint));
  return config;
}

/// A day in which every state and every order comes: start, motion, a release, another start, an end of session.
void liveWith(Rig& rig, Joint joint, const std::function<void()>& check) {
  const auto run = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      rig.cycle();
      check();
    }
  };
  rig.newSession();
  for (int i = 0; i < 2000 && rig.state() != State::kDriven; ++i) run(1);
  ASSERT_EQ(rig.state(), State::kDriven) << "the start does not wait for it";
  rig.joint(joint).setGoal(Rad{0.3});
  rig.joint(joint).setTorque(true);
  run(50);
  rig.joint(joint).setTorque(false);
  run(50);
  rig.commands.end_of_session = true;
  run(1500);
  EXPECT_EQ(rig.state(), State::kLimp);
}

TEST(AbsentJoint, GetsNeitherGoalNorTorqueSwitchAndIsNotAFault) {
  for (const Joint joint : {Joint::kNeck, Joint::kLegLowerR}) {
    Rig rig{lacking(&Config::absent, joint)};
    rig.robot[joint].answers = false;
    liveWith(rig, joint, [&] {
      ASSERT_FALSE(rig.driven(joint));
      ASSERT_FALSE(rig.safe->torqueOn()[index(joint)]);
      ASSERT_FALSE(rig.safe->torqueOff()[index(joint)]);
      ASSERT_FALSE(rig.active(Fault::kServoSilent));
    });
  }
}

/// What is not there has no torque that could be unknown.
TEST(AbsentJoint, AResetOfALimpRobotIsNotAFault) {
  Rig rig{lacking(&Config::absent, Joint::kNeck)};
  rig.robot[Joint::kNeck].answers = false;
  rig.run(60);
  ASSERT_EQ(rig.state(), State::kLimp);
  rig.robot.servo_power = false;
  rig.run(5);
  rig.robot.servo_power = true;
  rig.run(100);
  EXPECT_FALSE(rig.active(Fault::kBoardReset)) << "nothing was under torque";
}

TEST(LeftOutJoint, GetsNoGoalAndNoTorqueEvenWhenItAnswers) {
  for (const bool answers : {false, true}) {
    Rig rig{lacking(&Config::left_out, Joint::kNeck)};
    rig.robot[Joint::kNeck].answers = answers;
    bool reported = false;
    liveWith(rig, Joint::kNeck, [&] {
      ASSERT_FALSE(rig.driven(Joint::kNeck));
      ASSERT_FALSE(rig.safe->torqueOn()[index(Joint::kNeck)]);
      reported = reported || rig.active(Fault::kServoSilent);
    });
    EXPECT_EQ(reported, !answers) << "a silent servo that should be there is a fault";
  }
}

TEST(LeftOutJoint, ThatIsStiffIsSwitchedOffWithTheOthers) {
  Rig rig{lacking(&Config::left_out, Joint::kNeck)};
  rig.robot[Joint::kNeck].torque = true;
  liveWith(rig, Joint::kNeck, [] {});
  EXPECT_FALSE(rig.robot[Joint::kNeck].torque);
}

Config without(Joint joint) {
  Config config = lacking(&Config::left_out, joint);
  config.no_writes.set(index(joint));
  return config;
}

TEST(JointWithoutWrites, GetsNoTorqueOffEither) {
  Rig rig{without(Joint::kNeck)};
  liveWith(rig, Joint::kNeck, [&] {
    ASSERT_FALSE(rig.driven(Joint::kNeck));
    ASSERT_FALSE(rig.safe->torqueOn()[index(Joint::kNeck)]);
    ASSERT_FALSE(rig.safe->torqueOff()[index(Joint::kNeck)]);
  });
}

TEST(JointWithoutWrites, ThatIsStiffStaysSoAndIsReportedWhileTheOthersComeToRest) {
  Rig rig{without(Joint::kNeck)};
  rig.robot[Joint::kNeck].torque = rig.robot[Joint::kHead].torque = true;
  rig.newSession();
  rig.commands.unattended = true;
  rig.commands.end_of_session = true;
  ASSERT_GE(rig.runUntil([&] { return !rig.robot[Joint::kHead].torque; }), 0);
  rig.run(100);
  EXPECT_TRUE(rig.robot[Joint::kNeck].torque);
  EXPECT_EQ(rig.state(), State::kFoundStiff);
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.safe->write(), Write::kNothing) << "torque off is not repeated for it";
  }
}

}  // namespace
}  // namespace darwinop::safety
