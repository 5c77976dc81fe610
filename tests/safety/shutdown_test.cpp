// A servo that shuts itself off under overload is believed, whatever the controller changes in each step and wherever
// in the cycle it happens.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "safety/wire_rig.hpp"
#include "support/blocked_body.hpp"
#include "support/every_case.hpp"

namespace darwinop {
namespace {

constexpr std::size_t kBlocked = index(BlockedBody::kKnee);
constexpr std::size_t kNeck = index(Joint::kNeck);

struct Stall {
  int trips = 0;
  double seconds = 0;  // at full torque
};

/// A knee is blocked; `change` is what the controller asks for beside it in each step.
Stall stall(Nanos phase, const std::function<void(Commands&, int)>& change) {
  auto made = std::make_unique<BlockedBody>(phase);
  BlockedBody& body = *made;
  WireRig robot{std::move(made), bootsIn(Nanos{0})};
  robot.run(200);
  body.block();
  robot.commands.joint[kBlocked].setGoal(Rad{robot.seen().joint[kBlocked].position.value - 1.4});
  for (int i = 0; i < 62 * 30 && !robot.seen().safety.tripped[kBlocked]; ++i) {
    change(robot.commands, i);
    robot.cycle();
  }
  EXPECT_TRUE(robot.seen().safety.tripped[kBlocked]) << "never believed";
  return {body.trips(), body.stalledFor()};
}

/// Over all phases of a cycle.
Stall worst(const std::function<void(Commands&, int)>& change, Nanos step = std::chrono::microseconds{800}) {
  Stall all;
  for (Nanos phase{0}; phase < WireRig::kPeriod; phase += step) {
    const Stall one = stall(phase, change);
    all = {std::max(all.trips, one.trips), std::max(all.seconds, one.seconds)};
  }
  return all;
}

double wave(int step) {
  return std::sin(step * 0.3);
}

TEST(Shutdown, IsBelievedAtOnceWhenTheControllerAsksForPositionsOnly) {
  EXPECT_EQ(worst([](Commands&, int) {}).trips, 1);
}

TEST(Shutdown, IsBelievedAtOnceWhenTheSpeedOfTheJointChangesInEveryStep) {
  const Stall all = worst([](Commands& c, int i) { c.joint[kBlocked].setSpeedLimit(RadPerSec{3.0 + 0.5 * wave(i)}); });
  EXPECT_EQ(all.trips, 1);
  EXPECT_LT(all.seconds, BlockedBody::kTripsAfter + 0.1);
}

TEST(Shutdown, IsBelievedAtOnceWhenTheGainOfTheJointChangesInEveryStep) {
  const Stall all = worst([](Commands& c, int i) { c.joint[kBlocked].setPGain(6.0 + wave(i)); });
  EXPECT_EQ(all.trips, 1);
}

// A write of the torque limit is what makes a servo forget: it goes without a goal, and the torque that is off then is
// seen in the same cycle.
TEST(Shutdown, IsBelievedAtOnceWhenTorqueLimitsChangeInEveryStep) {
  constexpr Nanos kStep = kNextCase * std::chrono::microseconds{250};
  const Stall own =
      worst([](Commands& c, int i) { c.joint[kBlocked].setTorqueLimit(NewtonMeter{2.0 + 0.2 * wave(i)}); }, kStep);
  EXPECT_EQ(own.trips, 1);
  const Stall other =
      worst([](Commands& c, int i) { c.joint[kNeck].setTorqueLimit(NewtonMeter{2.0 + 0.2 * wave(i)}); }, kStep);
  EXPECT_EQ(other.trips, 1);
}

}  // namespace
}  // namespace darwinop
