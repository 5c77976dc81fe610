// A session that is stopped at any moment: nothing moves afterwards, and a limp robot stays limp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

std::array<double, kJoints> positions(const Rig& rig) {
  std::array<double, kJoints> all{};
  std::ranges::transform(rig.robot.servo, all.begin(), &FakeServo::position);
  return all;
}

bool anyTorque(const Rig& rig) {
  return std::ranges::any_of(rig.robot.servo, &FakeServo::torque);
}
bool allTorque(const Rig& rig) {
  return std::ranges::all_of(rig.robot.servo, &FakeServo::torque);
}

/// A stop: the last image of the session, after which the driver is silent.
void stop(Rig& rig) {
  rig.commands.hold = true;
  rig.cycle();
  rig.steps = false;
}

void expectNoMotionFor(Rig& rig, double seconds, const std::string& when) {
  const auto before = positions(rig);
  for (double time = 0; time < seconds; time += 0.016) {
    rig.cycle();
    for (std::size_t i = 0; i < kJoints; ++i)
      ASSERT_NEAR(rig.robot.servo[i].position, before[i], 1e-3) << kJointTable[i].name << " " << when;
  }
}

/// What on_exit says does not matter: there is nothing to sit down.
TEST(Hold, ARobotWithoutTorqueStaysLimpWheneverItIsStopped) {
  for (const OnExit how : {OnExit::kHold, OnExit::kKneel, OnExit::kLimp})
    for (int cycles = 1; cycles < 60; ++cycles) {
      Config config;
      config.on_exit = how;
      Rig rig{config};
      rig.newSession();
      rig.run(cycles);
      stop(rig);
      if (anyTorque(rig)) break;
      for (int i = 0; i < 1000; ++i) {
        rig.cycle();
        ASSERT_FALSE(anyTorque(rig)) << "stopped after " << cycles << " cycles, after another " << i;
      }
      EXPECT_EQ(rig.state(), State::kLimp) << cycles;
      EXPECT_FALSE(rig.active(Fault::kControllerGone)) << "the session has ended";
    }
}

TEST(Hold, AMoveToTheStartPoseEndsWhereItIs) {
  Rig rig;
  rig.robot[Joint::kShoulderR].position += 1.5;
  rig.newSession();
  ASSERT_TRUE(rig.reach(State::kStarting));
  rig.run(20);
  stop(rig);
  rig.run(2);  // what was sent before
  expectNoMotionFor(rig, 5, "during the move to the start pose");
  EXPECT_EQ(rig.state(), State::kHolding);
  EXPECT_TRUE(allTorque(rig));
}

TEST(Hold, ARobotThatAnotherProgramLeftStiffIsLeftAsItIs) {
  Rig rig;
  for (FakeServo& servo : rig.robot.servo) servo.torque = true;
  rig.run(60);
  ASSERT_EQ(rig.state(), State::kFoundStiff);
  rig.newSession();
  rig.cycle();
  ASSERT_EQ(rig.state(), State::kTakingOver);
  stop(rig);
  expectNoMotionFor(rig, 5, "found stiff");
  EXPECT_EQ(rig.state(), State::kFoundStiff);
  EXPECT_TRUE(allTorque(rig));
}

TEST(Hold, ARobotHeldByTheSessionBeforeIsHeldOn) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{0.3});
  rig.runFor(2);
  ASSERT_NEAR(rig.robot[Joint::kNeck].position, 0.3, 0.01);
  rig.newSession();
  rig.cycle();
  ASSERT_EQ(rig.state(), State::kTakingOver);
  stop(rig);
  expectNoMotionFor(rig, 5, "while it is taken over");
  EXPECT_EQ(rig.state(), State::kHolding);
  EXPECT_TRUE(allTorque(rig));
}

/// A person presses STOP, then plugs the USB cable in with a hand at the robot.
TEST(Hold, AStopDuringAnOutageHoldsAfterIt) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{0.3});
  rig.runFor(1);
  rig.robot.board_answers = false;
  rig.run(20);
  ASSERT_EQ(rig.state(), State::kOffline);
  stop(rig);
  rig.runFor(1);
  rig.robot.board_answers = true;
  expectNoMotionFor(rig, 5, "after an outage");
  EXPECT_TRUE(allTorque(rig));
}

/// As with every session whose driver is gone.
TEST(Hold, AfterGoneSItSitsDown) {
  Rig rig;
  rig.start();
  stop(rig);
  rig.runFor(rig.config.gone_s - 1);
  EXPECT_EQ(rig.state(), State::kHolding);
  EXPECT_TRUE(rig.reach(State::kKneeling));
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(Hold, TheNextSessionDrives) {
  Rig rig;
  rig.newSession();
  rig.run(2);
  stop(rig);
  rig.runFor(1);
  rig.commands.hold = false;
  rig.steps = true;
  rig.start();
}

}  // namespace
}  // namespace darwinop::safety
