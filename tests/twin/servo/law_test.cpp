// Webots' motor law: P sets a speed, limited, and so is its change; the torque is what that takes.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

ServoParameters webotsLaw(double accel = std::numeric_limits<double>::infinity()) {
  ServoParameters p;
  p.law = Law::kSpeedP;
  p.accel_max_rad_s2 = accel;
  return p;
}
constexpr Pendulum kWeightless{.payload_kg = 0.1, .gravity_m_s2 = 0};

TEST(WebotsLaw, ErrorSetsTheSpeedFromTheFirstPeriodOn) {
  Bench bench{webotsLaw(), {}, kWeightless};
  bench.step(driveTo(20 * kRadPerTick, 10));
  EXPECT_NEAR(bench.velocity_rad_s(), 10 * 20 * kRadPerTick, 1e-9);
}

// P / s of the error: exponential arrival. The period of 1 ms and the encoder's tick shift it by less than 1 %.
TEST(WebotsLaw, ArrivesExponentially) {
  ServoParameters strong = webotsLaw();
  strong.torque_max_nm = 1000;  // no time is lost on the way to the first speed
  Bench bench{strong, {}, kWeightless};
  run(bench, driveTo(1, 4), 0.25);
  EXPECT_NEAR(1 - bench.position_rad(), std::exp(-4 * 0.25), 0.01 * std::exp(-1));
}

TEST(WebotsLaw, SpeedIsLimitedByTheModelAndByTheMovingSpeed) {
  Bench bench{webotsLaw(), {}, kWeightless};
  run(bench, driveTo(3, 30), 0.05);
  EXPECT_EQ(bench.velocity_rad_s(), 12.26);
  bench.reset({});
  ServoDrive slow = driveTo(3, 30);
  slow.speed_limit_rad_s = 3;
  run(bench, slow, 0.05);
  EXPECT_EQ(bench.velocity_rad_s(), 3);
}

TEST(WebotsLaw, SpeedChangesByTheAccelerationOnly) {
  Bench bench{webotsLaw(55), {}, kWeightless};
  for (int i = 1; i <= 100; ++i) {
    bench.step(driveTo(3, 30));
    ASSERT_NEAR(bench.velocity_rad_s(), 0.055 * i, 1e-9);
  }
}

TEST(WebotsLaw, GivesNoMoreThanItsTorque) {
  Bench bench{webotsLaw(), {}, kWeightless};
  ServoDrive weak = driveTo(3, 30);
  weak.torque_limit = 0.1;  // of 2.5 N m
  run(bench, weak, 0.05);
  EXPECT_NEAR(bench.velocity_rad_s(), 0.25 / bench.inertia_kgm2() * 0.05, 1e-6);
  EXPECT_NEAR(bench.servo().report().load, 0.1, 1e-4);  // filtered with 5 ms: exp(-10) is left
}

// Load is the torque that holds the arm, not a duty.
TEST(WebotsLaw, LoadIsTheTorqueThatHolds) {
  Bench bench{webotsLaw(), {}, kArm};
  run(bench, driveTo(kPi / 2), 4);
  EXPECT_NEAR(bench.servo().report().load * 2.5, bench.weight_nm(), 0.001);
  Bench rough{webotsLaw(), friction(0.05, 0), kArm};
  run(rough, driveTo(kPi / 2), 4);
  EXPECT_NEAR(rough.servo().report().load * 2.5, rough.weight_nm() - 0.05, 0.001) << "friction holds its share";
}

TEST(WebotsLaw, KnowsNoOverload) {
  Bench bench{webotsLaw(), friction(10, 0), kWeightless};
  run(bench, driveTo(3, 30), 5);
  EXPECT_EQ(bench.velocity_rad_s(), 0);
  EXPECT_FALSE(bench.servo().report().overload);
}

TEST(WebotsLaw, LimpMeansLimp) {
  Bench bench{webotsLaw(), {}, kWeightless};
  bench.reset({.start_rad_s = 2});
  run(bench, kLimp, 0.5);
  EXPECT_EQ(bench.velocity_rad_s(), 2);
}

}  // namespace
}  // namespace darwinop::twin::testing
