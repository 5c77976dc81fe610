// When a phase ends because of what the robot does.
#include "experiments/run/watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace darwinop::experiments {
namespace {

constexpr double kPeriod = 0.016;
constexpr double kUnknownCount = std::numeric_limits<double>::quiet_NaN();

bool fallenAfter(double seconds, std::array<double, 3> counts) {
  FallWatch watch;
  for (double t = 0; t < seconds; t += kPeriod) watch.update(counts.data(), kPeriod);
  return watch.fallen();
}

TEST(FallWatch, LyingForAQuarterOfASecondIsFallen) {
  EXPECT_TRUE(fallenAfter(0.3, {512, 384, 512})) << "on its face: y is -1 g";
  EXPECT_FALSE(fallenAfter(0.2, {512, 384, 512}));
  EXPECT_FALSE(fallenAfter(5, {512, 512, 640})) << "upright";
  EXPECT_FALSE(fallenAfter(5, {512, 448, 623})) << "bowing by 30 degrees";
}

TEST(FallWatch, FortyFiveDegreesAreTheEdge) {
  EXPECT_FALSE(fallenAfter(5, {512, 430, 610})) << "40 degrees: 128 sin and cos of it";
  EXPECT_TRUE(fallenAfter(5, {512, 414, 594})) << "50 degrees";
  EXPECT_TRUE(fallenAfter(5, {610, 512, 594})) << "and to the side";
}

TEST(FallWatch, BlowsAndFreeFallAndSilenceTellNothing) {
  EXPECT_FALSE(fallenAfter(5, {512, 512 - 250, 512})) << "two g to one side are a blow";
  EXPECT_FALSE(fallenAfter(5, {512, 510, 512}));
  EXPECT_FALSE(fallenAfter(5, {kUnknownCount, kUnknownCount, kUnknownCount}));
}

class Ends : public testing::Test {
 protected:
  Ends() { phase.joints = {{Joint::kNeck, 1}}; }
  static Positions neckAt(double rad) {
    Positions seen{};
    seen[index(Joint::kNeck)] = rad;
    return seen;
  }
  Phase phase;
};

TEST_F(Ends, ArrivalIsWithinADistance) {
  phase.until = Until::kArrival;
  phase.within = 0.03;
  phase.arrive_at = 1.0;
  EndWatch end{phase, neckAt(0)};
  EXPECT_FALSE(end.over(neckAt(0.96), false, 1));
  EXPECT_TRUE(end.over(neckAt(0.98), false, 1));
  EXPECT_FALSE(end.over(neckAt(1.2), false, 1)) << "it overshoots, and comes back";
  EXPECT_FALSE(end.over(neckAt(std::nan("")), false, 1));
}

TEST_F(Ends, PushedJointMayPass) {
  phase.until = Until::kArrival;
  phase.within = 0.03;
  phase.arrive_at = 1.0;
  phase.torque = TorqueMode::kDirect;
  EndWatch end{phase, neckAt(0)};
  EXPECT_FALSE(end.over(neckAt(0.9), false, 1));
  EXPECT_TRUE(end.over(neckAt(1.2), false, 1));
}

TEST_F(Ends, RestIsHalfASecondWithoutMovement) {
  phase.until = Until::kRest;
  EndWatch end{phase, neckAt(0)};
  EXPECT_FALSE(end.over(neckAt(0.1), false, 0.4));
  EXPECT_FALSE(end.over(neckAt(0.101), false, 0.8));
  EXPECT_TRUE(end.over(neckAt(0.1), false, 0.91));
}

TEST_F(Ends, CreepingIsNotResting) {
  phase.until = Until::kRest;
  EndWatch end{phase, neckAt(0)};
  // 0.02 rad/s are seven ticks in half a second; a servo at rest may flicker by one.
  for (double t = 0; t < 3; t += kPeriod) ASSERT_FALSE(end.over(neckAt(0.02 * t), false, t)) << t;
  EndWatch flicker{phase, neckAt(0)};
  bool over = false;
  for (double t = 0; t < 0.6; t += kPeriod)
    over = over || flicker.over(neckAt(std::fmod(t, 0.1) < 0.05 ? 0 : 0.0016), false, t);
  EXPECT_TRUE(over);
}

TEST_F(Ends, SilentJointIsNotAtRest) {
  phase.until = Until::kRest;
  EndWatch end{phase, neckAt(0)};
  for (double t = 0; t < 3; t += kPeriod) EXPECT_FALSE(end.over(neckAt(std::nan("")), false, t));
}

TEST_F(Ends, FallenEndsOnlyAPhaseThatWaitsForIt) {
  EXPECT_FALSE((EndWatch{phase, neckAt(0)}.over(neckAt(0), true, 1)));
  phase.until = Until::kFallen;
  EXPECT_TRUE((EndWatch{phase, neckAt(0)}.over(neckAt(0), true, 1)));
}

}  // namespace
}  // namespace darwinop::experiments
