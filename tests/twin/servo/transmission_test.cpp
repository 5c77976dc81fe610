// Backlash and elasticity between gears and arm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

// A spring of any stiffness; in the catalogue a stiffness of 1000 N m/rad counts as rigid.
class AnySpring final : public Effect {
 public:
  AnySpring(double stiffness, double damping) : stiffness_{stiffness}, damping_{damping} {}
  [[nodiscard]] const EffectInfo& info() const noexcept override { return *findEffect("joint_flex"); }
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    s.flex_stiffness_nm_rad = stiffness_;
    s.flex_damping_nms_rad = damping_;
  }

 private:
  double stiffness_, damping_;
};

// Maximum deviation of the arm from the rigid model, over a step up and a release.
template <class Make>
double farFromRigid(Make&& make) {
  Bench soft{mx28(), make(), kArm}, rigid{mx28(), friction(kCoulomb, kViscous), kArm};
  soft.reset({.start_rad = -0.8});
  rigid.reset({.steps_per_period = 50, .start_rad = -0.8});
  double worst = 0;
  while (rigid.time_s() < 3) {
    const ServoDrive drive = rigid.time_s() < 1.5 ? driveTo(0.8) : kLimp;
    soft.step(drive);
    rigid.step(drive);
    worst = std::max(worst, std::abs(soft.position_rad() - rigid.position_rad()));
  }
  return worst;
}
double farWithSpring(double stiffness) {
  return farFromRigid([&] { return with(std::make_unique<AnySpring>(stiffness, 0.3), friction(kCoulomb, kViscous)); });
}
double farWithPlay(double play) {
  return farFromRigid([&] { return with(effect("backlash", {play}), friction(kCoulomb, kViscous)); });
}

// Deflection is torque / stiffness, with less than 0.5 N m at the arm; the release starts there.
TEST(Transmission, AStiffSpringIsTheRigidModel) {
  const double hundred = farWithSpring(100), thousand = farWithSpring(1000), hard = farWithSpring(10000);
  EXPECT_LT(hard, 0.3 * kRadPerTick);
  EXPECT_LT(hard, 0.25 * thousand);
  EXPECT_LT(thousand, 0.25 * hundred);
  EXPECT_GT(hundred, kRadPerTick);
}

TEST(Transmission, NarrowPlayIsTheRigidModelWithToothCompliance) {
  EXPECT_LT(farWithPlay(1e-6), 3e-3);  // 1000 N m/rad; a release from another deflection
  EXPECT_GT(farWithPlay(0.03), 0.01);
}

TEST(Transmission, WithoutPlayAndSpringIsRigid) {
  EXPECT_FALSE((Bench{mx28(), friction(1, 1), kArm}.servo().softGear()));
  EXPECT_TRUE((Bench{mx28(), with(effect("backlash", {0.01})), kArm}.servo().softGear()));
  EXPECT_TRUE((Bench{mx28(), with(effect("joint_flex", {50, 0.01})), kArm}.servo().softGear()));
}

// Gears held by friction; the arm oscillates on the spring and gravity: w^2 = (k + W cos q) / J_arm.
TEST(Transmission, TheArmOscillatesOnItsSpringWhileTheGearsAreAtRest) {
  Bench bench{mx28(), with(effect("joint_flex", {20, 0}), friction(10, 0)), kArm};
  bench.reset({.start_rad = 0.3});
  const double sag = bench.weight_nm() * std::sin(0.3) / 20;
  double before = bench.velocity_rad_s(), first = 0, last = 0;
  int turns = -1;
  while (bench.time_s() < 2) {
    bench.step(kLimp);
    const double now = bench.velocity_rad_s();
    if (before < 0 && now >= 0) {
      last = bench.time_s() - 0.001 * now / (now - before);
      if (++turns == 0) first = last;
    }
    before = now;
    ASSERT_EQ(bench.servo().signals().velocity_rad_s, 0);
    ASSERT_LE(bench.position_rad(), 0.3 + 1e-6);
    ASSERT_GE(bench.position_rad(), 0.3 - 2.02 * sag);
  }
  const double arm = bench.inertia_kgm2() - 0.003;
  const double expected = 2 * kPi / std::sqrt((20 + bench.weight_nm() * std::cos(0.3)) / arm);
  EXPECT_NEAR((last - first) / turns / expected, 1, 2e-3);  // sub-step of 0.25 rad: error of its square / 24
}

// Encoder on the motor side of the spring.
TEST(Transmission, TheEncoderDoesNotMeasureTheDeflection) {
  Bench bench{mx28(), with(effect("joint_flex", {10, 0.02}), friction(0, kViscous)), kArm};
  run(bench, driveTo(1.2, 8), 4);
  const double bent = bench.weight_nm() * std::sin(bench.position_rad()) / 10;
  EXPECT_NEAR(bench.servo().report().position_rad - bench.position_rad(), bent, kRadPerTick);
  EXPECT_GT(bent, 10 * kRadPerTick);
}

// Encoder on the horn: the arm falls through the play while the gears are at rest.
TEST(Transmission, TheEncoderMeasuresTheArmWithinThePlay) {
  constexpr double kPlay = 0.03;
  Bench bench{mx28(), with(effect("backlash", {kPlay}), friction(10, 0)), kArm};
  bench.reset({.start_rad = 0.5});
  run(bench, kLimp, 2);
  EXPECT_EQ(bench.servo().signals().position_rad, 0.5);
  const double give = bench.weight_nm() * std::sin(0.5) / 1000;
  EXPECT_NEAR(bench.position_rad(), 0.5 - kPlay / 2 - give, 1e-5);
  EXPECT_NEAR(bench.servo().report().position_rad, bench.position_rad(), kRadPerTick / 2);
}

// Limp and held by the friction of its gears, for which an arm that begins on unbent gears falls and swings.
TEST(Transmission, ASettledArmStaysWhereItIs) {
  for (const bool has_play : {true, false})
    for (const double start : {0.5, -0.5}) {
      auto soft = has_play ? effect("backlash", {0.03}) : effect("joint_flex", {5, 0.001});
      Bench bench{mx28(), with(std::move(soft), friction(10, 0)), kArm};
      bench.reset({.start_rad = start, .is_settled = true});
      EXPECT_NEAR(bench.encoder_rad(), start, 1e-9);
      const double arm = bench.position_rad();
      while (bench.time_s() < 1) {
        bench.step(kLimp);
        ASSERT_NEAR(bench.position_rad(), arm, 1e-6) << has_play;
        ASSERT_NEAR(bench.encoder_rad(), start, 1e-6) << has_play;
      }
    }
}

// Near the lowest point the arm swings freely within the play, with its own inertia and without friction.
TEST(Transmission, WithinThePlayTheArmIsFree) {
  Bench bench{mx28(), with(effect("backlash", {0.06}), friction(10, 0)), kArm};
  bench.reset({.start_rad = 0, .start_rad_s = 0.1});  // the gears stop, the arm continues
  const double arm = bench.inertia_kgm2() - 0.003, w = std::sqrt(bench.weight_nm() / arm);
  ASSERT_LT(0.1 / w, 0.02);  // it reverses before it reaches a tooth
  double most = 0, least = 0;
  while (bench.time_s() < 5) {
    bench.step(kLimp);
    most = std::max(most, bench.position_rad());
    least = std::min(least, bench.position_rad());
  }
  EXPECT_NEAR(most, 0.1 / w, 0.01 * 0.1 / w);
  EXPECT_NEAR(least, -0.1 / w, 0.01 * 0.1 / w);
}

// Spring and damper that only push: exp(-b t), t until the force is 0 (Schwager and Poeschel 1998). With pulling teeth
// it would be exp(-b pi / w), 5 % less.
TEST(Transmission, TeethPushAndDoNotPull) {
  Pendulum floating = kArm;
  floating.gravity_m_s2 = 0;
  Bench bench{mx28(), with(effect("backlash", {0.06}), friction(10, 0)), floating};
  bench.reset({.steps_per_period = 50, .start_rad_s = 0.5});
  while (bench.velocity_rad_s() > 0) bench.step(kLimp);
  run(bench, kLimp, 0.01);
  const double arm = bench.inertia_kgm2() - 0.003, b = 0.4 / (2 * arm), w0 = std::sqrt(1000 / arm);
  const double w = std::sqrt(w0 * w0 - b * b), t = (kPi - std::atan(2 * b * w / (w0 * w0 - 2 * b * b))) / w;
  EXPECT_NEAR(-bench.velocity_rad_s() / 0.5, std::exp(-b * t), 0.01 * std::exp(-b * t));
}

// The scheme needs sub-steps that resolve the lightest body; an arm without inertia would need endless ones.
TEST(Transmission, AnArmWithoutInertiaFollowsTheGearsInAffordableSteps) {
  constexpr double kPlay = 0.03;
  const Pendulum nothing{.payload_kg = 0, .arm_mass_kg = 0, .length_m = 0.1};
  Bench bench{mx28(), with(effect("backlash", {kPlay}), friction(kCoulomb, kViscous)), nothing};
  Transmission gears;
  gears.reset(0, 0, mx28().armature_kgm2);
  EXPECT_LE(gears.stepsFor(bench.servo().signals(), 0, mx28().firmware_period_s), 100);
  bench.reset({});
  run(bench, driveTo(0.5), 1);
  EXPECT_NEAR(bench.position_rad(), 0.5, 0.02) << "within friction and play";
}

TEST(Transmission, SpringAndTeethNeverAddEnergy) {
  for (int i = 0; i < 2; ++i) {
    Bench bench{mx28(), with(i == 0 ? effect("joint_flex", {50, 0}) : effect("backlash", {0.03})), kArm};
    bench.reset({.start_rad = 1.5});
    const double start = bench.energy_j();
    double most = 0;
    for (int k = 0; k < 5000; ++k) {
      bench.step(kLimp);
      most = std::max(most, bench.energy_j());
    }
    EXPECT_LT(most, start * 1.01);  // energy oscillation of the scheme: (0.25 rad)^2 / 8
    if (i == 0) {
      EXPECT_GT(bench.energy_j(), start * 0.99);
    }
  }
}

}  // namespace
}  // namespace darwinop::twin::testing
