// Effects that help only together.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "gap/fit/solve.hpp"
#include "gap/identify/effect_set.hpp"
#include "gap/identify/identification.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

constexpr double kPeakSpeed = 1.2, kDamping = 0.09;  // rad/s, N m s/rad

/// Sines of one peak speed.
template <int kHundredthHz>
double sine(double t) {
  constexpr double kOmega = 2 * std::numbers::pi * kHundredthHz / 100;
  return kPeakSpeed / kOmega * std::sin(kOmega * t);
}

/// The model has the friction of the servo as dry friction of 0.08 N m. Nearly all of it is viscous, and at this one
/// peak speed a sine of the one resembles a sine of the other.
Case wrongKindOfFriction() {
  Case bench = smallBench();
  bench.model.servo.firmware_period_s = 0.002;  // half the work
  bench.model.effects = {{.info = twin::findEffect("coulomb"), .values = {0.08}, .joint = {}}};
  bench.logs.clear();
  bench.logs.push_back(commanded("slow", 4, 16, 0.3, &sine<30>));
  bench.logs.push_back(commanded("middle", 4, 16, 0.3, &sine<45>));
  bench.logs.push_back(commanded("light", 4, 16, 0.2, &sine<60>));
  bench.logs.push_back(commanded("soft", 4, 12, 0.2, &sine<40>));
  bench.logs.push_back(commanded("kept", 4, 12, 0.3, &sine<50>));
  bench.logs.back().held_out = true;
  Hypothesis truth = baselineOf(bench);
  valueOf(truth.with(*twin::findEffect("coulomb")), "friction") = 0.004;
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = kDamping;
  return measured(bench, truth, 5);
}

double costWith(const Study& study, const std::vector<std::string_view>& ids) {
  Effects effects;
  for (const std::string_view id : ids) effects.push_back({twin::findEffect(id)});
  const Problem problem = problemWith(study, study.evidence, effects, Nuisance::kFixed);
  return solve(problem, problem.expected()).cost;
}

TEST(Pairs, OfFrictionThatHelpOnlyTogetherAreNamed) {
  const Case given = wrongKindOfFriction();
  const Study study{given};
  const double none = costWith(study, {}), both = costWith(study, {"coulomb", "viscous"});
  for (const std::string_view alone : {"coulomb", "viscous"})
    ASSERT_GT(costWith(study, {alone}), none - 0.05 * (none - both)) << "a saddle";
  ASSERT_LT(costWith(study, {"kt_error"}), none - 0.05 * (none - both)) << "what stands in for the two";
  const Identification found = identify(study);
  EXPECT_EQ(found.verdict, Verdict::kNamed);
  ASSERT_EQ(found.effects.size(), 2U);
  for (const IdentifiedEffect& one : found.effects) {
    const bool viscous = one.effect->id == "viscous";
    EXPECT_TRUE(viscous || one.effect->id == "coulomb") << one.effect->id;
    EXPECT_NEAR(one.estimates.front().value, viscous ? kDamping : 0.004, 0.003);
  }
}

}  // namespace
}  // namespace darwinop::gap
