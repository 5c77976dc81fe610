// Identifies the missing effect, and reports none when nothing is missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gap/identify/assessment.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/results.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

using ::testing::Contains;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

Identification namedIn(const Case& given) {
  return identify(Study{given});
}

std::string idOf(const Identification& identification) {
  return identification.effects.empty() ? "" : std::string{identification.effects.front().effect->id};
}

/// A fit with this effect at `values`.
FittedModel sayingOf(const Study& study, std::string_view id, const std::vector<double>& values) {
  auto evidence = std::make_shared<const Evidence>(study.evidence);
  const Effects effects{{twin::findEffect(id)}};
  Problem problem = problemWith(study, *evidence, effects, Nuisance::kFixed);
  Fit fit;
  fit.x = problem.expected();
  for (std::size_t i = 0; i < values.size(); ++i)
    fit.x[static_cast<Eigen::Index>(i)] = problem.unknowns()[i].toSearch(values[i]);
  return {&study, effects, Nuisance::kFixed, std::move(evidence), std::move(problem), std::move(fit), 0};
}

// Seen as the second effect of a delay under the law speed_p: what such a fit gains is the rounding of a position.
TEST(Judging, ADeadBandOfFourMicroradiansIsNothing) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 3);
  const Study study{given, {.runs = 4, .disturbance = {}}};
  const auto is_nothing = [&](std::string_view id, const std::vector<double>& values) {
    return isNegligible(sayingOf(study, id, values), *twin::findEffect(id));
  };
  EXPECT_TRUE(is_nothing("deadband", {4e-6}));
  EXPECT_FALSE(is_nothing("deadband", {0.0025}));
  EXPECT_TRUE(is_nothing("com_mass", {0.0001, 0}));
  EXPECT_FALSE(is_nothing("com_mass", {0, 0.01})) << "one of its parameters has an influence";
  EXPECT_FALSE(is_nothing("accel_limit", {9990})) << "an encoder shows it";
}

// A base that leans one way in the fitted logs, and the other way in the held-out one.
TEST(Identification, AnEffectThatWorsensHeldOutLogsIsNotNamed) {
  const Case bench = smallBench();
  Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.12), 12);
  const Case other = measured(bench, withEffect(bench, "encoder_offset", "offset", -0.12), 12);
  given.logs.back() = other.logs.back();
  const Identification identification = namedIn(given);
  EXPECT_EQ(identification.verdict, Verdict::kUnknown) << idOf(identification);
  EXPECT_TRUE(identification.effects.empty());
  ASSERT_FALSE(identification.rejected.empty());
  EXPECT_EQ(identification.rejected.front().effect->id, "encoder_offset");
  EXPECT_EQ(identification.rejected.front().why, RejectionReason::kWorsensHeldOut);
  EXPECT_GT(identification.misfit, 4) << "of the baseline, which remains";
}

TEST(Identification, ARightModelHasNoFinding) {
  const Case bench = smallBench();
  const Identification identification = namedIn(measured(bench, baselineOf(bench), 11));
  EXPECT_EQ(identification.verdict, Verdict::kNone) << idOf(identification);
  EXPECT_LT(std::abs(identification.misfit), 4);
}

TEST(Identification, NumbersThatAreOffWithinTheirPriorsAreNotAFinding) {
  const Case bench = smallBench();
  Hypothesis truth = baselineOf(bench);
  truth.servo.resistance_ohm *= 1.03;
  truth.servo.armature_kgm2 *= 0.93;
  truth.payload_scale = 1.007;
  const Identification identification = namedIn(measured(bench, truth, 12));
  EXPECT_EQ(identification.verdict, Verdict::kNone) << idOf(identification);
  EXPECT_GT(identification.gap_before_rad, 1.5 * identification.gap_after_rad) << "they do move";
}

TEST(Identification, DryFriction) {
  const Case bench = smallBench();
  const Identification identification = namedIn(measured(bench, withEffect(bench, "coulomb", "friction", 0.04), 13));
  ASSERT_EQ(identification.verdict, Verdict::kNamed) << idOf(identification);
  ASSERT_EQ(idOf(identification), "coulomb");
  const Estimate& friction = identification.effects.front().estimates.front();
  EXPECT_NEAR(friction.value, 0.04, 0.002);
  EXPECT_LT(friction.low, friction.value);
  EXPECT_GT(friction.high, friction.value);
  EXPECT_LT(identification.gap_after_rad, 2 * identification.floor_rad);
}

// While the sagging supply is still missing, directional friction explains a little of it.
TEST(Identification, ATooComplexEffectIsSimplified) {
  const Case bench = smallBench();
  Hypothesis truth = withEffect(bench, "load_dependent_friction", "share", 0.3);
  valueOf(truth.with(*twin::findEffect("supply_sag")), "resistance") = 3;
  const Identification identification = namedIn(measured(bench, truth, 31));
  EXPECT_EQ(identification.verdict, Verdict::kNamed);
  std::vector<std::string_view> ids;
  ASSERT_EQ(identification.effects.size(), 2U);
  EXPECT_GT(identification.effects.front().gain, identification.effects.back().gain) << "the strongest first";
  for (const IdentifiedEffect& found : identification.effects) {
    ids.push_back(found.effect->id);
    EXPECT_GT(found.gain, identification.threshold) << found.effect->id;
  }
  EXPECT_THAT(ids, UnorderedElementsAre("load_dependent_friction", "supply_sag"));
  for (const Rival& rival : identification.rivals) {
    EXPECT_EQ(rival.effects.size(), 2U);
    EXPECT_THAT(rival.effects, Not(Contains("directional_load_friction"))) << "it was simplified there as well";
    EXPECT_NE(rival.effects.front(), rival.effects.back());
  }
}

TEST(Identification, ADeadBandIsDistinguishedFromDryFriction) {
  const Case bench = smallBench();
  const Identification identification = namedIn(measured(bench, withEffect(bench, "deadband", "width", 0.01), 14));
  EXPECT_EQ(idOf(identification), "deadband");
}

// As strong as the catalogue allows; an effect that stands in for another one also ends there.
TEST(Identification, AnEffectAtTheEndOfItsRange) {
  const Case bench = smallBench();
  const Identification identification = namedIn(measured(bench, withEffect(bench, "deadband", "width", 0.04), 16));
  EXPECT_EQ(identification.verdict, Verdict::kNamed);
  EXPECT_EQ(idOf(identification), "deadband");
}

// Two sigma off, while six other numbers are right to a tenth of theirs.
TEST(Identification, ASingleWrongNumber) {
  Case bench = smallBench();
  bench.priors.push_back({"viscous.damping", 0.1});
  const Identification identification = namedIn(measured(bench, withEffect(bench, "viscous", "damping", 0.018), 17));
  EXPECT_EQ(identification.verdict, Verdict::kNamed);
  ASSERT_EQ(idOf(identification), "viscous");
  EXPECT_NEAR(identification.effects.front().estimates.front().value, 0.018, 0.0005);
}

TEST(Identification, ARivalWithMoreParametersHasToBeCloser) {
  Identification identification;
  identification.effects.push_back({.effect = twin::findEffect("coulomb"), .estimates = {}});
  identification.rivals.push_back({.effects = {"stribeck"}, .behind = 5});
  EXPECT_EQ(verdictOf(identification), Verdict::kAmbiguous);
  identification.rivals.front().larger = true;
  EXPECT_EQ(verdictOf(identification), Verdict::kNamed);
  identification.rivals.front().behind = 3;
  EXPECT_EQ(verdictOf(identification), Verdict::kAmbiguous);
}

// All residuals together are as large as the noise; in the direction of this effect they are larger.
TEST(Identification, AnEffectBarelyAboveTheNoise) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.004), 19);
  const Identification identification = namedIn(given);
  ASSERT_EQ(idOf(identification), "encoder_offset");
  EXPECT_NEAR(identification.effects.front().estimates.front().value, 0.004, 0.001);
  EXPECT_LT(identification.gap_before_rad, 3 * identification.floor_rad) << "a small gap";
}

TEST(Outcome, TheRepairedModelHasTheEffectAndReadsBack) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 15);
  const Outcome outcome = investigate(given);
  ASSERT_EQ(idOf(outcome.identification), "encoder_offset");
  EXPECT_LT(outcome.verification.rms_after_rad, 0.3 * outcome.verification.rms_before_rad) << "on a held-out log";
  const twin::Model repaired =
      twin::parseModel(withAdditions(caseModel(given), additionsOf(given, outcome, "")), "repaired.ini");
  ASSERT_EQ(repaired.effects.size(), 2U);
  const nlohmann::json json = asJson(given, outcome);
  EXPECT_EQ(json["verdict"], "named");
  EXPECT_NEAR(json["effects"][0]["params"]["offset"].get<double>(), 0.03, 0.001);
  const std::string text = asText(given, outcome);
  EXPECT_NE(text.find("encoder_offset"), std::string::npos);
  EXPECT_NE(text.find(messages::kHeldOutLogs), std::string::npos);
}

}  // namespace
}  // namespace darwinop::gap
