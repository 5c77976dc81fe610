// Which joints may be under torque when a loop ends.
#include "runtime/torque_left.hpp"

#include <gtest/gtest.h>

#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

constexpr std::size_t kNeck = index(Joint::kNeck), kKnee = index(Joint::kLegLowerR);

/// Limp, every servo was just polled.
Sensors limpImage() {
  Sensors seen;
  seen.cycle = 100;
  seen.safety.state = State::kLimp;
  seen.board.motion.received();
  seen.board.servo_power = true;
  for (JointSensors& joint : seen.joint) {
    joint.motion.received();
    joint.polled.received();
  }
  return seen;
}

JointSet left(const Sensors& seen) {
  return perhapsUnderTorque(seen, everAnswered(seen));
}

TEST(TorqueLeft, ALimpRobotHasNone) {
  EXPECT_TRUE(left(limpImage()).none());
}

TEST(TorqueLeft, AServoWithTorqueIsNamedWhateverTheState) {
  for (const State state : {State::kLimp, State::kFoundStiff, State::kHolding, State::kDriven}) {
    Sensors seen = limpImage();
    seen.safety.state = state;
    seen.joint[kNeck].torque_enabled = seen.joint[kKnee].torque_enabled = true;
    EXPECT_EQ(namesOf(left(seen)), "LegLowerR, Neck");
  }
}

TEST(TorqueLeft, AServoThatWasNotPolledForTwoRoundsIsUnknown) {
  Sensors seen = limpImage();
  seen.joint[kNeck].polled.age = 50;
  EXPECT_TRUE(left(seen).none());
  seen.joint[kNeck].polled.age = 51;
  EXPECT_EQ(namesOf(left(seen)), "Neck");
  seen.joint[kNeck].polled.age = Freshness::kNever;
  EXPECT_EQ(namesOf(left(seen)), "Neck") << "it answers, its torque was never read";
}

TEST(TorqueLeft, AServoThatNeverAnsweredIsAbsentUnlessAnEarlierLoopKnewIt) {
  Sensors seen = limpImage();
  seen.joint[kNeck].motion.age = seen.joint[kNeck].polled.age = Freshness::kNever;
  EXPECT_TRUE(left(seen).none());
  EXPECT_EQ(namesOf(perhapsUnderTorque(seen, JointSet{}.set())), "Neck");
}

TEST(TorqueLeft, BehindASilentBoardNothingIsKnown) {
  Sensors seen = limpImage();
  seen.safety.state = State::kOffline;
  EXPECT_EQ(namesOf(left(seen)), messages::kAllJoints);
  seen.board.servo_power = false;  // an old value
  EXPECT_EQ(namesOf(left(seen)), messages::kAllJoints);
}

TEST(TorqueLeft, WithoutServoPowerThereIsNone) {
  Sensors seen = limpImage();
  seen.board.servo_power = false;
  for (JointSensors& joint : seen.joint) joint.polled.age = 1000;
  seen.joint[kNeck].torque_enabled = true;
  seen.board.motion.age = kAnswerPatience;
  EXPECT_TRUE(left(seen).none());
  seen.board.motion.age = kAnswerPatience + 1;  // the board's value is old
  EXPECT_TRUE(left(seen).all());
}

}  // namespace
}  // namespace darwinop::runtime
