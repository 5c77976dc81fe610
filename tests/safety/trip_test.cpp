// A servo that shut itself off is left alone until somebody asks for it.
#include <gtest/gtest.h>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr Joint kKnee = Joint::kLegLowerL;

/// What a servo does by itself.
void shutOff(FakeServo& servo, std::uint8_t bits) {
  servo.error_bits = bits;
  servo.torque = false;
  servo.torque_limit = 0;
}

TEST(Trip, AnErrorBitStopsGoalsAtOnceAndIsAFaultWhenConfirmed) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverload);
  rig.cycle();  // read in this cycle
  rig.cycle();
  EXPECT_FALSE(rig.driven(kKnee)) << "a routine write would arm it again";
  EXPECT_FALSE(rig.active(Fault::kServoOverload));
  rig.cycle();
  EXPECT_TRUE(rig.active(Fault::kServoOverload));
  EXPECT_EQ(rig.report().worst_joint, row(kKnee).id);
  EXPECT_TRUE(rig.report().tripped[index(kKnee)]);
  EXPECT_TRUE(rig.report().controller_must_end);
  EXPECT_EQ(rig.state(), State::kKneeling);
}

TEST(Trip, ATrippedServoIsNeverDrivenUntilAsked) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverload);
  rig.run(2);
  // The write that was under way when it shut itself off could not be helped; this is about those that follow.
  rig.robot[kKnee].torque_limit = 0;
  rig.robot[kKnee].error_bits = 0;  // the cause goes away by itself
  for (int i = 0; i < 1000; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.driven(kKnee));
    ASSERT_FALSE(rig.safe->torqueOn()[index(kKnee)]);
  }
  EXPECT_EQ(rig.state(), State::kLimp);
  EXPECT_EQ(rig.robot[kKnee].torque_limit, 0);
}

TEST(Trip, OneCorruptedErrorByteIsNotAFaultAndTheJointRestartsWhereItIs) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  rig.robot[kKnee].error_bits = error_bit::kOverload;
  rig.cycle();
  rig.robot[kKnee].error_bits = 0;
  rig.cycle();
  EXPECT_FALSE(rig.driven(kKnee));
  rig.robot[kKnee].torque = false;  // it was off after all, and swung away
  rig.robot[kKnee].position += 0.2;
  ASSERT_GE(rig.runUntil([&] { return rig.driven(kKnee); }), 0);
  EXPECT_NEAR(rig.goal(kKnee), rig.robot[kKnee].position, 0.02);
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Trip, AfterAResetTorqueLimitAndTorqueAreBothRestoredFromThePresentPosition) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverload);
  ASSERT_TRUE(rig.reach(State::kKneeling));
  ASSERT_TRUE(rig.reach(State::kLimp));
  rig.robot[kKnee].error_bits = 0;
  rig.robot[kKnee].position += 0.3;
  const double present = rig.robot[kKnee].position;
  ++rig.commands.fault_resets;
  ASSERT_GE(rig.runUntil([&] { return rig.driven(kKnee); }), 0);
  EXPECT_NEAR(rig.goal(kKnee), present, kRadPerTick);
  ASSERT_TRUE(rig.reach(State::kDriven));
  EXPECT_TRUE(rig.robot[kKnee].torque);
  EXPECT_EQ(rig.robot[kKnee].torque_limit, 2.5);
  EXPECT_TRUE(rig.report().active.none());
  EXPECT_TRUE(rig.report().tripped.none());
}

TEST(Trip, AnOverloadThatIsStillThereAfterAResetTripsAgain) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverload);
  ASSERT_TRUE(rig.reach(State::kKneeling));
  ASSERT_TRUE(rig.reach(State::kLimp));
  ++rig.commands.fault_resets;
  ASSERT_GE(rig.runUntil([&] { return rig.active(Fault::kServoOverload); }), 0);
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(Trip, AnOverloadBitThatGoesAwayUnderTorqueIsOnlyAMemory) {
  Rig rig;
  rig.robot[kKnee].remembers = true;
  rig.start();
  rig.runFor(2);
  EXPECT_TRUE(rig.driven(kKnee));
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Trip, AnOverheatedServoIsNotDrivenByAResetWhileItsBitIsSet) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverheat);
  ASSERT_TRUE(rig.reach(State::kKneeling));
  EXPECT_TRUE(rig.active(Fault::kServoOverheat));
  ASSERT_TRUE(rig.reach(State::kLimp));
  ++rig.commands.fault_resets;
  for (int i = 0; i < 200; ++i) {
    rig.cycle();
    ASSERT_FALSE(rig.driven(kKnee));
    ASSERT_TRUE(rig.active(Fault::kServoOverheat)) << "still there: latched again at once";
    ASSERT_EQ(rig.state(), State::kLimp);
  }
}

TEST(Trip, TorqueSwitchedOffAndOnByTheControllerAsksForThatJoint) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  shutOff(rig.robot[kKnee], error_bit::kOverload);
  ASSERT_TRUE(rig.reach(State::kKneeling));
  rig.robot[kKnee].error_bits = 0;
  rig.joint(kKnee).setTorque(false);
  rig.run(2);
  EXPECT_TRUE(rig.report().tripped[index(kKnee)]);
  rig.joint(kKnee).setTorque(true);
  rig.run(6);
  EXPECT_FALSE(rig.report().tripped[index(kKnee)]);
  EXPECT_TRUE(rig.driven(kKnee)) << "it helps with the kneel";
  EXPECT_TRUE(rig.active(Fault::kServoOverload)) << "which a controller cannot call off";
  EXPECT_TRUE(rig.reach(State::kLimp));
}

TEST(Trip, ThePollFindsATorqueLimitOfZeroWithoutAnyErrorBit) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  rig.robot[kKnee].receives = false;  // so that the fake is not armed again before it is polled
  shutOff(rig.robot[kKnee], 0);
  ASSERT_GE(rig.runUntil([&] { return !rig.driven(kKnee); }), 0) << "suspected at the first poll";
  EXPECT_FALSE(rig.active(Fault::kServoOverload));
  rig.robot[kKnee].receives = true;
  rig.runFor(0.5);
  EXPECT_TRUE(rig.active(Fault::kServoOverload)) << "confirmed by the second";
  EXPECT_EQ(rig.robot[kKnee].torque_limit, 0) << "not armed by a routine write";
}

TEST(Trip, ATorqueLimitOfZeroThatTheControllerAskedForIsNotAShutdown) {
  Rig rig;
  rig.start();
  rig.joint(kKnee).setTorqueLimit(NewtonMeter{0});
  rig.runFor(3);
  EXPECT_TRUE(rig.driven(kKnee));
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Trip, AServoThatRestartedIsTakenOverAgainWithoutAsking) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  rig.robot[kKnee].answers = false;  // its supply flickered
  rig.robot[kKnee].torque = false;
  rig.run(10);
  rig.robot[kKnee].answers = true;
  rig.runFor(2);
  EXPECT_TRUE(rig.robot[kKnee].torque);
  EXPECT_TRUE(rig.driven(kKnee));
  EXPECT_TRUE(rig.report().active.none());
}

TEST(Trip, TorqueThatGoesOffWhileTheServoKeepsAnsweringIsAShutdown) {
  Rig rig;
  rig.start();
  rig.runFor(1);
  rig.robot[kKnee].torque = false;
  rig.runFor(1);
  EXPECT_TRUE(rig.active(Fault::kServoOverload));
}

}  // namespace
}  // namespace darwinop::safety
