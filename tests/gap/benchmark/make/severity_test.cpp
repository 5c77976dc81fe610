// Effects have the requested strength, where a bench shows them at all.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gap/benchmark/make/make_case.hpp"
#include "gap/benchmark/make/outside.hpp"
#include "gap/benchmark/make/severities.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> catalogueIds() {
  std::vector<std::string> ids;
  for (const twin::EffectInfo* const info : twin::catalogue()) ids.emplace_back(info->id);
  return ids;
}

// Even the end of their plausible range is within some floors.
bool isFaint(std::string_view id) {
  return id == "encoder_quantisation" || id == "resistance_error";
}

Hidden hiddenAt(const std::string& id, int severity, std::uint64_t seed) {
  CaseRequest request;
  request.seed = seed;
  request.baseline = id == "p_on_torque" ? Baseline::kSpeed
                     : id == "coulomb"   ? Baseline::kFrictionless  // where there is some, a prior has its say
                                         : Baseline::kFriction;
  request.effects = {{.id = id, .severity = severity}};
  return hidden(request);
}

class EachEffect : public testing::TestWithParam<std::string> {};

TEST_P(EachEffect, AtSeverityTwoOpensAGap) {
  const Hidden made = hiddenAt(GetParam(), 2, 12);
  const int severity = made.key.effects[0].severity;
  if (isFaint(GetParam())) {
    EXPECT_LT(severity, 2);
    return;
  }
  EXPECT_EQ(severity, GetParam() == "p_on_torque" ? 3 : 2);  // the law is there or is not
  EXPECT_GT(made.key.gap_fit_rad, 5 * kFloor);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EachEffect, testing::ValuesIn(catalogueIds()),
                         [](const auto& tested) { return tested.param; });

TEST(Severity, IsTheGapThatItMeans) {
  const CasePlan plan = drawnPlan("c001", Baseline::kFriction, 21);
  const Hypothesis bench = baselineOf(plan.given);
  for (const int severity : {1, 2, 3}) {
    Rng rng{33};
    const Strength found = strengthOf(plan.given, bench, *twin::findEffect("transport_delay"), severity, rng);
    EXPECT_EQ(found.severity, severity);
    EXPECT_GT(found.gap_rad, gapRangeOf(severity).low_rad * 0.89);
    EXPECT_LT(found.gap_rad, gapRangeOf(severity).high_rad * 1.11);
    Rng again{33};
    EXPECT_EQ(strengthOf(plan.given, bench, *twin::findEffect("transport_delay"), severity, again).values,
              found.values);
  }
}

TEST(Severity, IsWhatTheRangeAllowsWhereThatIsLess) {
  const CasePlan plan = drawnPlan("c001", Baseline::kFriction, 21);
  Rng rng{1};
  const twin::EffectInfo& info = *twin::findEffect("resistance_error");
  const Strength found = strengthOf(plan.given, baselineOf(plan.given), info, 3, rng);
  EXPECT_LT(found.severity, 3);
  EXPECT_DOUBLE_EQ(std::abs(found.values[0]), 0.9 * 0.15)
      << "an estimate at the end of the range has no upper interval end";
}

// A payload that is known to 2 % and is 1 % heavier makes no finding: `none` would be the right answer.
TEST(Severity, IsMoreThanThePriorOfTheNumberThatTheEffectMeans) {
  CasePlan plan = drawnPlan("c001", Baseline::kFriction, 21);
  plan.given.priors = {{.number = "payload", .relative_sigma = 0.02}, {.number = "length", .relative_sigma = 0.02}};
  const twin::EffectInfo& heavier = *twin::findEffect("com_mass");
  const Case known = plan.given;
  plan.given.priors.clear();
  double least = 100;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    for (const Case* const given : std::initializer_list<const Case*>{&known, &plan.given}) {
      Rng rng{seed};
      Hypothesis bench = baselineOf(*given);
      bench.payload_scale = 1.01;  // and the scales were half a sigma wrong
      bench.with(heavier).values = strengthOf(*given, bench, heavier, 1, rng).values;
      const double sigmas = priorSigmasMoved(known, baselineOf(known), bench, heavier);
      if (given == &known)
        EXPECT_GT(sigmas, 3) << seed;
      else
        least = std::min(least, sigmas);
    }
  }
  EXPECT_LT(least, 2) << "otherwise this test has no meaning";
}

TEST(Severity, IsNoneWhereThePriorAllowsAllOfTheRange) {
  CasePlan plan = drawnPlan("c001", Baseline::kFriction, 21);
  plan.given.priors = {{.number = "kt", .relative_sigma = 0.15}};
  Rng rng{1};
  EXPECT_EQ(strengthOf(plan.given, baselineOf(plan.given), *twin::findEffect("kt_error"), 1, rng).severity, 0);
}

TEST(Severity, OfAnEffectThatTheLawDoesNotHaveIsNone) {
  const CasePlan plan = drawnPlan("c001", Baseline::kSpeed, 21);
  Rng rng{1};
  EXPECT_EQ(strengthOf(plan.given, baselineOf(plan.given), *twin::findEffect("supply_sag"), 2, rng).severity, 0);
  EXPECT_EQ(severityOfGap(0.003), 1);
  EXPECT_EQ(severityOfGap(0.02), 2);
  EXPECT_EQ(severityOfGap(0.05), 3);
}

class EachOutsideEffect : public testing::TestWithParam<std::string> {};

TEST_P(EachOutsideEffect, ShowsWhereTheKeySays) {
  const Hidden made = hiddenAt(GetParam(), 0, 14);
  EXPECT_EQ(made.key.kind, CaseClass::kOutside);
  EXPECT_GT(made.key.gap_fit_rad, 3 * kFloor);
  ASSERT_FALSE(made.key.places.empty());
  for (const KeyPlace& place : made.key.places) {
    const auto log = std::ranges::find(made.given.logs, place.file, &Trajectory::file);
    ASSERT_NE(log, made.given.logs.end());
    EXPECT_FALSE(log->held_out);
    EXPECT_LE(place.from_s, place.to_s);
    EXPECT_LE(place.to_s, log->time_s.back());
  }
}

std::vector<std::string> outsideIds() {
  std::vector<std::string> ids;
  for (const OutsideInfo& info : outsideCatalogue()) ids.emplace_back(info.id);
  return ids;
}
INSTANTIATE_TEST_SUITE_P(Outside, EachOutsideEffect, testing::ValuesIn(outsideIds()),
                         [](const auto& tested) { return tested.param; });

TEST(OutsideEffects, FollowTheClockOfTheSession) {
  const Hidden bump = hiddenAt("u_bump", 0, 3);
  for (const KeyPlace& place : bump.key.places) EXPECT_EQ(place.file, "fit_3.csv");  // fit_4 repeats it, untouched
  CaseRequest request;
  request.effects = {{.id = "u_string", .values = {{"snaps", 16}}}};
  for (const KeyPlace& place : hidden(request).key.places)
    EXPECT_THAT(place.file, testing::AnyOf("fit_1.csv", "fit_2.csv"));
}

}  // namespace
}  // namespace darwinop::gap
