// A stuck encoder is reported; a joint that merely does not move is not.
#include <gtest/gtest.h>

#include <functional>

#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr Joint kSwung = Joint::kArmLowerR;

struct SwingingElbow : Rig {
  double middle = 0;

  SwingingElbow() {
    start();
    middle = robot[kSwung].position;
    controller = [this](Rig& rig) {
      rig.joint(kSwung).setGoal(Rad{middle + (rig.robot.seen.cycle / 62 % 2 == 0 ? 0.4 : -0.4)});
    };
  }
  /// Over ten seconds, in each cycle.
  bool isReported(const std::function<void()>& each = [] {}) {
    for (int i = 0; i < 625; ++i) {
      each();
      cycle();
      if (active(Fault::kEncoderStuck)) return true;
    }
    return false;
  }
};

TEST(Encoder, APositionThatStaysTheSameWhileTheServoPushesBothWaysIsReported) {
  SwingingElbow rig;
  rig.robot[kSwung].stuck_at = rig.middle;
  EXPECT_TRUE(rig.isReported());
  EXPECT_EQ(rig.report().worst_joint, row(kSwung).id);
  EXPECT_EQ(rig.state(), State::kDriven) << "reported, nothing else";
}

TEST(Encoder, LostAnswersDoNotHideIt) {
  SwingingElbow rig;
  rig.robot[kSwung].stuck_at = rig.middle;
  int i = 0;
  EXPECT_TRUE(rig.isReported([&] { rig.robot[kSwung].answers = ++i % 10 != 0; }));
}

TEST(Encoder, AJointThatMovesIsWell) {
  EXPECT_FALSE(SwingingElbow{}.isReported());
}

TEST(Encoder, AJointThatIsBlockedFromOneSideIsWell) {
  SwingingElbow rig;
  rig.robot[kSwung].follows = false;
  rig.controller = [&](Rig& r) { r.joint(kSwung).setGoal(Rad{rig.middle + 0.4}); };
  EXPECT_FALSE(rig.isReported());
}

TEST(Encoder, AJointThatIsHeldByHandGivesWayByATick) {
  SwingingElbow rig;
  rig.robot[kSwung].follows = false;
  EXPECT_FALSE(rig.isReported(
      [&] { rig.robot[kSwung].position = rig.middle + (rig.robot[kSwung].goal > rig.middle ? 1 : -1) * kRadPerTick; }));
}

TEST(Encoder, ALimpJointIsWell) {
  SwingingElbow rig;
  rig.joint(kSwung).setTorque(false);
  EXPECT_FALSE(rig.isReported());
}

TEST(Encoder, AServoThatFindsItsTorqueOffIsWell) {
  SwingingElbow rig;
  rig.robot[kSwung].follows = false;
  EXPECT_FALSE(rig.isReported([&] { rig.robot[kSwung].torque = false; }));
}

TEST(Encoder, AJointThatMayHardlyPushIsWell) {
  const std::array<std::function<void(JointCommand&)>, 3> weak{
      [](JointCommand& c) { c.setTorqueLimit(NewtonMeter{0.5}); }, [](JointCommand& c) { c.setPGain(0.5); },
      [](JointCommand& c) { c.setSpeedLimit(RadPerSec{0.1}); }};
  for (const auto& weaken : weak) {
    SwingingElbow rig;
    rig.robot[kSwung].follows = false;
    weaken(rig.joint(kSwung));
    EXPECT_FALSE(rig.isReported());
  }
}

}  // namespace
}  // namespace darwinop::safety
