// What effects do to friction.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

/// Most torque that dry friction takes, torque off, at this speed.
double dryFriction(const std::vector<Chosen>& choice, double speed_rad_s) {
  Servo servo = servoWith(choice);
  return servo.actuate(0, speed_rad_s, 0).friction_nm;
}

/// The same with the motor and the load pulling, torques in N m.
double loadedFriction(const std::vector<Chosen>& choice, double motor_nm, double external_nm, double speed_rad_s = 0) {
  ServoParameters parameters;
  parameters.ticks_per_rev = 1e9;  // the torque shall be what is asked for
  parameters.back_emf_vs_rad = 0;
  Servo servo = servoWith(choice, parameters);
  servo.firmware(driveTo(motor_nm / 2.5 / (32 * parameters.duty_per_kp_per_rad)), 0, 0);
  const double friction = servo.actuate(0, speed_rad_s, external_nm).friction_nm;
  EXPECT_NEAR(servo.signals().motor_torque_nm, motor_nm, 1e-6);
  return friction;
}

TEST(Coulomb, IsTheSameAtEverySpeed) {
  for (const double speed : {-5.0, 0.0, 0.1, 5.0})
    EXPECT_NEAR(dryFriction({{"coulomb", {{"friction", 0.05}}}}, speed), 0.05, 1e-12);
}

TEST(Coulomb, HoldsALoadBelowItAndLetsGoAboveIt) {
  const Bench weight{{}, {}, kArm};
  for (const double angle : {0.3, 0.6}) {
    const double needed = weight.weight_nm() * std::sin(angle);
    for (const double share : {0.98, 1.02}) {
      Bench bench{{}, effectsOf({{"coulomb", {{"friction", share * needed}}}}), kArm};
      bench.reset({.start_rad = angle});
      runFor(bench, 1, ServoDrive{});
      EXPECT_EQ(bench.position_rad() == angle, share > 1) << angle;
    }
  }
}

TEST(Viscous, GrowsWithSpeedThroughTheDamping) {
  Servo servo = servoWith({{"viscous", {{"damping", 0.02}}}});
  const Actuation out = servo.actuate(0, 3, 0);
  EXPECT_NEAR(out.damping_nms_rad, 0.02, 1e-12);
  EXPECT_EQ(out.friction_nm, 0);
}

// Seed finding: a swing with viscous friction alone dies by the same factor each time and ends at the lowest point.
TEST(Viscous, LetsASwingDieByTheSameFactorEachTime) {
  Bench bench{{}, effectsOf({{"viscous", {{"damping", 0.002}}}}), kArm};
  bench.reset({.start_rad = 0.2});  // small, so that the period does not depend on the amplitude
  std::vector<double> peaks;
  double before = 0;
  for (int i = 0; i < 4000; ++i) {
    bench.step({});
    if (before > 0 && bench.velocity_rad_s() <= 0) peaks.push_back(bench.position_rad());
    before = bench.velocity_rad_s();
  }
  ASSERT_GE(peaks.size(), 4U);
  // Over one period T the envelope falls by exp(-kv T / 2 J); T = 2 pi sqrt(J / weight).
  const double j = bench.inertia_kgm2();
  const double factor = std::exp(-0.002 / (2 * j) * 2 * std::numbers::pi * std::sqrt(j / bench.weight_nm()));
  for (std::size_t i = 1; i < peaks.size(); ++i) EXPECT_NEAR(peaks[i] / peaks[i - 1], factor, 0.005);
}

TEST(Stribeck, FadesAsTheJointMoves) {
  const std::vector<Chosen> choice{{"stribeck", {{"friction", 0.06}, {"speed", 0.3}}}};
  EXPECT_NEAR(dryFriction(choice, 0), 0.06, 1e-12);
  EXPECT_NEAR(dryFriction(choice, 0.3), 0.06 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(dryFriction(choice, -0.3), 0.06 * std::exp(-1.0), 1e-12);
  EXPECT_LT(dryFriction(choice, 3), 0.0001);
}

TEST(Stribeck, FadesMoreSharplyWithALargerExponent) {
  const auto at = [](double speed) {
    return dryFriction({{"stribeck", {{"friction", 0.06}, {"speed", 0.3}, {"exponent", 2}}}}, speed);
  };
  EXPECT_NEAR(at(0.15), 0.06 * std::exp(-0.25), 1e-12);
  EXPECT_NEAR(at(0.6), 0.06 * std::exp(-4.0), 1e-12);
}

TEST(LoadDependentFriction, GrowsWithTheLoadThatIsHeld) {
  for (const double load : {0.0, 0.4, -0.8})
    EXPECT_NEAR(loadedFriction({{"load_dependent_friction", {{"share", 0.1}}}}, -load, load), 0.2 * std::abs(load),
                1e-6);
}

TEST(DirectionalLoadFriction, IsLessWhenTheLoadDrivesTheMotor) {
  const std::vector<Chosen> choice{{"directional_load_friction", {{"motor", 0.1}, {"load", 0.05}}}};
  EXPECT_NEAR(loadedFriction(choice, 1, -0.8), 0.1 + 0.04, 1e-6);  // lifting
  EXPECT_NEAR(loadedFriction(choice, 0, -0.8), 0.04, 1e-6);        // limp, the load pulls
  EXPECT_NEAR(loadedFriction(choice, 0.4, 0.8), 0, 1e-6);          // both pull the same way
}

TEST(DirectionalLoadFriction, HasAPartThatFadesWithSpeed) {
  const std::vector<Chosen> choice{
      {"directional_load_friction", {{"slow_motor", 0.1}, {"slow_load", 0.1}, {"slow_speed", 0.5}}}};
  EXPECT_NEAR(loadedFriction(choice, 1, -1, 0), 0.2, 1e-6);
  EXPECT_NEAR(loadedFriction(choice, 1, -1, 0.5), 0.2 * std::exp(-1.0), 1e-6);
}

TEST(QuadraticLoadFriction, IsFourTimesAsLargeAtTwiceTheTorque) {
  const std::vector<Chosen> choice{{"quadratic_load_friction", {{"motor", 0.01}, {"load", 0.004}}}};
  EXPECT_NEAR(loadedFriction(choice, 1, 0), 0.01, 1e-7);
  EXPECT_NEAR(loadedFriction(choice, 2, 0), 0.04, 1e-7);
  EXPECT_NEAR(loadedFriction(choice, 1, -1), 0.014, 1e-7);
}

TEST(QuadraticLoadFriction, MayFadeWithSpeed) {
  const std::vector<Chosen> choice{{"quadratic_load_friction", {{"motor", 0.01}, {"fade_speed", 0.5}}}};
  EXPECT_NEAR(loadedFriction(choice, 1, 0, 0.5), 0.01 * std::exp(-1.0), 1e-7);
}

Servo warmServo(double temperature_c, const std::vector<Chosen>& choice) {
  ServoParameters parameters;
  parameters.ambient_c = temperature_c;
  return servoWith(choice, parameters);
}

TEST(TempDrift, ScalesAllFrictionAndNotTheBackEmf) {
  const std::vector<Chosen> choice{{"coulomb", {{"friction", 0.05}}},
                                   {"viscous", {{"damping", 0.02}}},
                                   {"stribeck", {{"friction", 0.03}}},
                                   {"temp_drift", {{"rate", 0.02}, {"reference", 25}}}};
  Servo at25 = warmServo(25, choice), at55 = warmServo(55, choice);
  EXPECT_NEAR(at25.actuate(0, 0, 0).friction_nm, 0.08, 1e-9);
  EXPECT_NEAR(at55.actuate(0, 0, 0).friction_nm, 0.08 * std::exp(-0.6), 1e-9);
  EXPECT_NEAR(at55.actuate(0, 0, 0).damping_nms_rad, 0.02 * std::exp(-0.6), 1e-9);
  at55.firmware(driveTo(1), 0, 0);
  const double back_emf =
      ServoParameters{}.kt_nm_a * ServoParameters{}.back_emf_vs_rad / ServoParameters{}.resistance_ohm;
  EXPECT_NEAR(at55.actuate(0, 0, 0).damping_nms_rad, 0.02 * std::exp(-0.6) + back_emf, 1e-6);
}

TEST(TempDrift, MakesCopperWorseAsItWarms) {
  const std::vector<Chosen> choice{{"temp_drift", {{"copper", 0.0039}}}};
  Servo servo = warmServo(65, choice);
  servo.firmware(driveTo(1), 0, 0);
  EXPECT_NEAR(servo.signals().resistance_ohm / ServoParameters{}.resistance_ohm, 1.156, 1e-6);
}

TEST(TempDrift, FollowsTheServoAsItHeatsUp) {
  Servo servo = servoWith({{"coulomb", {{"friction", 0.05}}}, {"temp_drift", {{"rate", 0.05}}}});
  for (int i = 0; i < 20000; ++i) {  // 20 s against a stop
    servo.firmware(driveTo(1), 0, 0);
    servo.actuate(0, 0, 0);
  }
  const double warmer = servo.signals().temperature_c - 25;
  EXPECT_GT(warmer, 2);
  // The friction was made one period before the last warming.
  EXPECT_NEAR(servo.signals().dry_friction_nm, 0.05 * std::exp(-0.05 * warmer), 1e-5);
}

}  // namespace
}  // namespace darwinop::twin
