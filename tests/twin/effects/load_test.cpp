// Effects on transmission and load.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/conversions.hpp"
#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

/// Gears held by friction against any load of the arm.
const Chosen kStuck{"coulomb", {{"friction", 0.3}}};
/// An arm too light to move them.
constexpr Pendulum kLight{.payload_kg = 0.1, .arm_mass_kg = 0.02, .length_m = 0.1};

/// Mean duration of ten half swings after a push at the lowest point, s.
double halfSwing(const std::vector<Chosen>& choice, const Pendulum& pendulum) {
  Bench bench{{}, effectsOf(choice), pendulum};
  bench.reset({.steps_per_period = 10, .start_rad_s = 0.05});
  double first = 0, side = 1;
  for (int turns = 0; bench.time_s() < 10;) {
    bench.step({});
    if (bench.velocity_rad_s() * side > 0) continue;
    side = -side;
    if (turns == 0) first = bench.time_s();
    if (++turns == 11) return (bench.time_s() - first) / 10;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(Backlash, ArmMovesWithinTheGapWhileTheGearsAreAtRest) {
  for (const double play : {0.0, 0.03}) {
    Bench bench{{}, effectsOf({kStuck, {"backlash", {{"play", play}}}}), kLight};
    bench.reset({.start_rad = 0.1});
    double low = 1;
    for (int i = 0; i < 2000; ++i) {
      bench.step({});
      low = std::min(low, bench.position_rad());
    }
    // From the middle of the gap the arm falls to a flank; tooth compliance is below 0.1 mrad.
    EXPECT_NEAR(0.1 - low, play / 2, 0.001);
  }
}

TEST(JointFlex, ArmDeflectsUnseenByTheEncoder) {
  Bench bench{{}, effectsOf({kStuck, {"joint_flex", {{"stiffness", 10}, {"damping", 0.05}}}}), kLight};
  bench.reset({.start_rad = 1});
  runFor(bench, 3, ServoDrive{});
  const double droop = 1 - bench.position_rad();
  EXPECT_NEAR(droop, bench.weight_nm() * std::sin(bench.position_rad()) / 10, 1e-4);
  EXPECT_GT(droop, 5 * kRadPerTick);
  EXPECT_NEAR(bench.servo().report().position_rad, 1, kRadPerTick);
}

TEST(JointFlex, RingsMoreSlowlyWithAHeavierArm) {
  const std::vector<Chosen> choice{kStuck, {"joint_flex", {{"stiffness", 20}, {"damping", 0}}}};
  for (const double payload : {0.05, 0.2}) {
    const Pendulum arm{.payload_kg = payload, .length_m = 0.1, .gravity_m_s2 = 0};
    EXPECT_NEAR(halfSwing(choice, arm), std::numbers::pi * std::sqrt(payload * 0.01 / 20), 0.0002)
        << payload << " kg; ten half swings are counted in whole milliseconds";
  }
}

TEST(ComMass, ScalesOrShiftsTheMass) {
  const double plain = Bench{{}, {}, kArm}.weight_nm();
  const Bench heavier{{}, effectsOf({{"com_mass", {{"mass", 0.2}}}}), kArm};
  const Bench longer{{}, effectsOf({{"com_mass", {{"shift", 0.01}}}}), kArm};
  EXPECT_NEAR(heavier.weight_nm() / plain, 1.2, 1e-9);
  EXPECT_NEAR(longer.weight_nm() - plain, 0.34 * 9.80665 * 0.01, 1e-9);
}

TEST(ComMass, NegativeShiftIsLimitedToTheAxis) {
  const Bench bench{
      {}, effectsOf({{"com_mass", {{"mass", 0}, {"shift", -0.05}}}}), {.payload_kg = 0.2, .length_m = 0.03}};
  EXPECT_EQ(bench.weight_nm(), 0);
}

TEST(Inertia, IsRefusedIfTheTotalWouldBeNegative) {
  ServoParameters light;
  light.armature_kgm2 = 0.001;
  try {
    const Servo servo{light, effectsOf({{"inertia", {{"change", -0.0015}}}})};
    FAIL() << "a negative inertia was accepted";
  } catch (const std::runtime_error& error) {
    const std::string why = error.what();
    for (const char* part : {"armature = 0.001", "change = -0.0015", "[effect inertia]"})  // no message
      EXPECT_NE(why.find(part), std::string::npos) << why;
  }
}

TEST(Inertia, SlowsTheSwingAndAddsNoWeight) {
  const std::vector<Chosen> choice{{"inertia", {{"change", 0.0015}}}};
  const Bench plain{{}, {}, kArm}, changed{{}, effectsOf(choice), kArm};
  EXPECT_NEAR(changed.weight_nm(), plain.weight_nm(), 1e-12);
  EXPECT_NEAR(changed.inertia_kgm2() - plain.inertia_kgm2(), 0.0015, 1e-12);
  const double ratio = std::sqrt(changed.inertia_kgm2() / plain.inertia_kgm2());
  // Ten half swings are 4.5 s, counted in whole milliseconds.
  EXPECT_NEAR(halfSwing(choice, kArm) / halfSwing({}, kArm), ratio, 0.001);
}

TEST(EncoderOffset, IsTheRestingAngleOfTheArm) {
  Bench bench{{}, effectsOf({{"viscous", {{"damping", 0.05}}}, {"encoder_offset", {{"offset", 0.04}}}}), kArm};
  bench.reset({.start_rad = 0.5});
  runFor(bench, 5, ServoDrive{});
  EXPECT_NEAR(bench.position_rad(), 0.04, 1e-3);
}

TEST(EncoderOffset, StopsShortByDifferentAmountsLeftAndRight) {
  const auto droop_at = [](double goal) {
    Bench bench{{}, effectsOf({{"encoder_offset", {{"offset", 0.1}}}}), kArm};
    runFor(bench, 3, driveTo(goal));
    return std::abs(goal - bench.position_rad());
  };
  const double weight = Bench{{}, {}, kArm}.weight_nm(), slope = 2.5 * 32 * ServoParameters{}.duty_per_kp_per_rad;
  EXPECT_NEAR(droop_at(0.6), weight * std::sin(0.5) / slope, 2 * kRadPerTick);
  EXPECT_NEAR(droop_at(-0.6), weight * std::sin(0.7) / slope, 2 * kRadPerTick);
  EXPECT_GT(droop_at(-0.6) - droop_at(0.6), 3 * kRadPerTick);
}

}  // namespace
}  // namespace darwinop::twin
