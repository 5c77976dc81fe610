// A controller drives: its commands within limits, torque switched off and on, LEDs, silence and return.
#include <gtest/gtest.h>

#include <limits>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

std::uint32_t hits(const Rig& rig, Limit limit) {
  return rig.report().limit_hits[static_cast<std::size_t>(limit)];
}

TEST(Driving, UnsetFieldsHaveTheDefaultsAndTheGoalStays) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  const auto& goal = rig.safe->goal(Joint::kNeck);
  EXPECT_EQ(goal.goal, radFromTicks(2050));
  EXPECT_NEAR(goal.speed_limit.value, 12.21, 1e-9);
  EXPECT_EQ(goal.torque_limit, NewtonMeter{2.5});
  EXPECT_EQ(goal.p_gain, 4.0);
}

TEST(Driving, ASetFieldIsCarriedOutAndStaysWhenItIsNoLongerSet) {
  Rig rig;
  rig.start();
  auto& neck = rig.joint(Joint::kNeck);
  neck.setGoal(Rad{0.5});
  neck.setSpeedLimit(RadPerSec{2});
  neck.setTorqueLimit(NewtonMeter{1});
  neck.setPGain(8);
  rig.runFor(1);
  neck.set = 0;
  rig.runFor(0.2);
  const SafeCommands::JointGoal wanted{Rad{0.5}, RadPerSec{2}, NewtonMeter{1}, 8};
  EXPECT_EQ(rig.safe->goal(Joint::kNeck), wanted);
}

TEST(Driving, GoalsOutsideTheLimitsAreClampedAndCounted) {
  Config config;
  config.set("Limits", "Head", "-0.1, 0.1");
  Rig rig{config};
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{100});
  rig.joint(Joint::kHead).setGoal(Rad{-3});
  rig.runFor(2);
  EXPECT_EQ(rig.goal(Joint::kNeck), hardRange(Joint::kNeck).high.value);
  EXPECT_EQ(rig.goal(Joint::kHead), -0.1);
  EXPECT_GT(hits(rig, Limit::kPosition), 200u);
}

TEST(Driving, NotANumberKeepsThePreviousGoalAndIsCounted) {
  Rig rig;
  rig.start();
  auto& neck = rig.joint(Joint::kNeck);
  neck.setGoal(Rad{0.5});
  rig.runFor(1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    neck.setGoal(Rad{bad});
    neck.setPGain(bad);
    neck.setSpeedLimit(RadPerSec{bad});
    neck.setTorqueLimit(NewtonMeter{bad});
    rig.run(3);
    const SafeCommands::JointGoal kept{Rad{0.5}, RadPerSec{12.21}, NewtonMeter{2.5}, 4};
    EXPECT_EQ(rig.safe->goal(Joint::kNeck), kept);
  }
  EXPECT_EQ(hits(rig, Limit::kNotFinite), 2u * 3 * 4);
}

TEST(Driving, AFarGoalIsApproachedAtTheGreatestSpeedPerNominalPeriod) {
  for (const int ms : {8, 16}) {
    Config config;
    config.period = std::chrono::milliseconds{ms};
    Rig rig{config};
    rig.start();
    const double before = rig.goal(Joint::kNeck);
    rig.joint(Joint::kNeck).setGoal(Rad{1.6});
    rig.cycle();
    EXPECT_NEAR(rig.goal(Joint::kNeck) - before, 12.26 * ms / 1000, 1e-9);
    EXPECT_EQ(hits(rig, Limit::kRate), 1u);
  }
}

TEST(Driving, ThePeriodOfTheLoopCountsNotThatOfTheConfiguration) {
  Rig rig;
  rig.robot.period_ns = 8'000'000;
  rig.start();
  const double before = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{1.6});
  rig.cycle();
  EXPECT_NEAR(rig.goal(Joint::kNeck) - before, 12.26 * 0.008, 1e-9);
}

TEST(Driving, GoalsWaitForABoardThatDoesNotAnswer) {
  for (const bool only_its_reply_is_lost : {false, true}) {
    Rig rig;
    rig.start();
    rig.joint(Joint::kNeck).setGoal(Rad{1.6});
    (only_its_reply_is_lost ? rig.robot.board_reply_lost : rig.robot.board_answers) = only_its_reply_is_lost;
    rig.run(1);
    const double sent = rig.goal(Joint::kNeck);
    rig.run(3);
    EXPECT_EQ(rig.goal(Joint::kNeck), sent) << "it may have received none of them";
    rig.robot.board_reply_lost = false;
    rig.robot.board_answers = true;
    rig.run(2);
    EXPECT_GT(rig.goal(Joint::kNeck), sent);
  }
}

TEST(Driving, ImagesOfNobodyAreNotObeyed) {
  Rig rig;
  rig.start();
  rig.steps = false;
  rig.commands.session = 0;  // the lease is free; what stands in the image is left over
  rig.joint(Joint::kNeck).setGoal(Rad{1});
  const double before = rig.goal(Joint::kNeck);
  rig.run(10);
  EXPECT_EQ(rig.goal(Joint::kNeck), before);
  EXPECT_EQ(rig.report().session, 1u);
  EXPECT_TRUE(rig.reach(State::kKneeling));
}

TEST(Driving, AnOverrunDoesNotMakeTheNextStepLonger) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.6});
  rig.robot.seen.time_ns += 900'000'000;  // the loop stood still
  rig.robot.seen.wake_latency_ns = 900'000'000;
  const double before = rig.goal(Joint::kNeck);
  rig.cycle();
  EXPECT_LE(rig.goal(Joint::kNeck) - before, 12.26 * 0.016 + 1e-9);
}

TEST(Driving, TorqueOffTakesEffectInThatCycleAndTheJointIsLeftOut) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kShoulderL).setTorque(false);
  rig.cycle();
  EXPECT_EQ(rig.safe->write(), Write::kTorque);
  EXPECT_EQ(rig.safe->torqueOff().count(), 1u);
  EXPECT_TRUE(rig.safe->torqueOff()[index(Joint::kShoulderL)]);
  EXPECT_FALSE(rig.driven(Joint::kShoulderL));
  EXPECT_FALSE(rig.robot[Joint::kShoulderL].torque);
  for (int i = 0; i < 100; ++i) {
    rig.cycle();
    ASSERT_EQ(rig.safe->write(), Write::kGoals);
    ASSERT_FALSE(rig.driven(Joint::kShoulderL));
    ASSERT_TRUE(rig.driven(Joint::kShoulderR));
  }
}

TEST(Driving, ALostTorqueOffIsSentAgain) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kShoulderL).setTorque(false);
  rig.robot[Joint::kShoulderL].receives = false;
  rig.cycle();
  rig.robot[Joint::kShoulderL].receives = true;
  EXPECT_TRUE(rig.robot[Joint::kShoulderL].torque);
  rig.runFor(1);
  EXPECT_FALSE(rig.robot[Joint::kShoulderL].torque);
}

TEST(Driving, TorqueOnAgainGoesThroughThePresentPositionAndIsGentle) {
  Rig rig;
  rig.start();
  auto& shoulder = rig.joint(Joint::kShoulderL);
  shoulder.setGoal(Rad{0.7});
  shoulder.setTorque(false);
  rig.runFor(0.5);
  rig.robot[Joint::kShoulderL].position = -0.5;  // moved by hand
  rig.run(1);
  shoulder.setTorque(true);
  ASSERT_GE(rig.runUntil([&] { return rig.driven(Joint::kShoulderL); }), 0);
  EXPECT_NEAR(rig.goal(Joint::kShoulderL), -0.5, kRadPerTick);
  EXPECT_EQ(rig.safe->write(), Write::kGoals) << "the goal first";
  rig.cycle();
  EXPECT_EQ(rig.safe->write(), Write::kTorque) << "then torque";
  EXPECT_TRUE(rig.safe->torqueOn()[index(Joint::kShoulderL)]);
  double last = rig.goal(Joint::kShoulderL);
  while (last < 0.7) {
    rig.cycle();
    ASSERT_LE(rig.goal(Joint::kShoulderL) - last, 1.194 * 0.016 + 1e-9);
    last = rig.goal(Joint::kShoulderL);
  }
}

TEST(Driving, AFewMissedReadingsChangeNothing) {
  Rig rig;
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  for (int i = 0; i < 60; ++i) {
    rig.robot[Joint::kNeck].answers = i % (kAnswerPatience + 1) == 0;
    rig.cycle();
    ASSERT_TRUE(rig.driven(Joint::kNeck));
  }
  EXPECT_EQ(rig.goal(Joint::kNeck), 1.0);
}

TEST(Driving, LedsArePassedOnWithinTheirBits) {
  Rig rig;
  rig.commands.led.setHead(0xFFFF);
  rig.commands.led.setPanel(0xFF);
  rig.cycle();
  EXPECT_EQ(rig.safe->led(), LedCommand{}) << "offline";
  rig.run(2);
  EXPECT_EQ(rig.safe->led().head, 0x7FFF);
  EXPECT_EQ(rig.safe->led().panel, 7);
  EXPECT_FALSE(rig.safe->led().has(LedCommand::kEye));
}

TEST(Driving, AStalledControllerIsHeldWhereItIsAndResumesWithBoundedSpeed) {
  Rig rig;
  rig.start();
  auto& neck = rig.joint(Joint::kNeck);
  neck.setGoal(Rad{0.5});
  rig.runFor(1);
  rig.steps = false;
  rig.runFor(1);
  EXPECT_EQ(rig.state(), State::kHolding);
  EXPECT_TRUE(rig.driven(Joint::kNeck));
  EXPECT_EQ(rig.goal(Joint::kNeck), 0.5);
  neck.setGoal(Rad{-1.5});  // an image that changes without its number is not obeyed to the full
  rig.cycle();
  EXPECT_EQ(rig.goal(Joint::kNeck), 0.5);
  rig.steps = true;
  rig.cycle();
  EXPECT_EQ(rig.state(), State::kDriven);
  EXPECT_NEAR(rig.goal(Joint::kNeck), 0.5 - 12.26 * 0.016, 1e-9);
}

TEST(Driving, HotServosMakeAllJointsGentle) {
  Rig rig;
  rig.start();
  rig.robot[Joint::kAnkleL].celsius = 66;
  rig.runFor(1);
  ASSERT_TRUE(rig.active(Fault::kServoHot));
  const double before = rig.goal(Joint::kNeck);
  rig.joint(Joint::kNeck).setGoal(Rad{1.5});
  rig.run(10);
  EXPECT_NEAR(rig.goal(Joint::kNeck) - before, 10 * 1.194 * 0.016, 1e-9);
  EXPECT_NEAR(rig.safe->goal(Joint::kNeck).speed_limit.value, 1.194, 1e-9);
}

}  // namespace
}  // namespace darwinop::safety
