// Which effects promise most before any fit; what left-out logs and intervals say of those that were fitted.
#include "gap/identify/screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gap/identify/assessment.hpp"
#include "gap/identify/cross_validation.hpp"
#include "gap/identify/jackknife.hpp"
#include "gap/identify/ripple_starts.hpp"
#include "gap/identify/start_grid.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

FittedModel fitWith(const Study& study, const Effects& effects, Nuisance nuisance, int rounds = 1) {
  const Problem problem = problemWith(study, study.evidence, effects, nuisance);
  Fit start;
  start.x = problem.expected();
  return refit(study, effects, nuisance, problem, start, rounds);
}

FittedModel baselineOn(const Study& study, Nuisance nuisance) {
  return fitWith(study, {}, nuisance);
}

TEST(Judge, ANumberWithinItsPriorHasToGainWhatAnyEffectHasTo) {
  const Case bench = smallBench();  // its payload is known to 1 %
  const Study study{bench, {.runs = 2, .disturbance = {}}};
  const auto least = [&](const char* effect, const char* key, double value) {
    return leastGain(study, withEffect(bench, effect, key, value), *twin::findEffect(effect), 16);
  };
  EXPECT_EQ(least("com_mass", "mass", 0.01), 16);
  EXPECT_EQ(least("com_mass", "mass", -0.05), thresholds::kPriorReleaseGain);
  EXPECT_EQ(least("viscous", "damping", 0.02), 16) << "nobody has said how well it is known";
  EXPECT_EQ(least("encoder_offset", "offset", 0.05), 16);
}

std::vector<const twin::EffectInfo*> threeEffects() {
  return {twin::findEffect("encoder_offset"), twin::findEffect("transport_delay"), twin::findEffect("supply_sag")};
}

TEST(Screen, WhatIsMissingPromisesMost) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 21);
  const Study study{given};
  const FittedModel present = baselineOn(study, Nuisance::kFixed);
  const Screen screen{present, threeEffects()};
  EXPECT_EQ(screen.candidates().front().effect->id, "encoder_offset");
  EXPECT_GT(screen.candidates().front().predicted_gain, 100);
}

TEST(Screen, ASharpenedProbeIsWhereTheTruthIs) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 22);
  const Study study{given};
  const FittedModel present = baselineOn(study, Nuisance::kFree);
  const Screen screen{present, {twin::findEffect("encoder_offset")}};
  const Candidate first = screen.candidates().front();
  const RefinedStart sharp = screen.refinedStart(first);
  EXPECT_NEAR(sharp.candidate.values[0], 0.03, 0.003);
  EXPECT_GT(sharp.candidate.predicted_gain, 0.9 * first.predicted_gain);
}

TEST(Screen, NoisePromisesLittle) {
  const Case bench = smallBench();
  const Case given = measured(bench, baselineOf(bench), 23);
  const Study study{given};
  const FittedModel present = baselineOn(study, Nuisance::kFixed);
  const Screen screen{present, threeEffects()};
  EXPECT_LT(screen.candidates().front().predicted_gain, 30);
  EXPECT_LT(screen.greatestPredictedGain(Eigen::VectorXd::Zero(present.evidence->size())), 1e-9);
}

// With 0.06 N m sixteen times a turn, an arm comes to rest in other dips than without: what is linear over a whole log
// has nothing to say.
TEST(Screen, ARippleIsSeenInShortWindows) {
  const Case bench = smallBench();
  Hypothesis truth = baselineOf(bench);
  truth.with(*twin::findEffect("cogging")).values = {0.06, 16, -1.46};
  const Case given = measured(bench, truth, 27);
  const Study study{given};
  const std::vector<Candidate> ripples = ripplesOf(baselineOn(study, Nuisance::kFixed));
  ASSERT_FALSE(ripples.empty());
  EXPECT_NEAR(ripples.front().values[0], 0.06, 0.015);
  EXPECT_EQ(ripples.front().values[1], 16);
  EXPECT_NEAR(ripples.front().values[2], -1.46, 0.2);
}

TEST(Grid, HasBothSidesOfWhereAnEffectDoesNothing) {
  double least = 0, greatest = 0, strictest = 1, mildest = 0;
  for (const auto& point : gridOf(unknownsOf(*twin::findEffect("temp_drift")))) {
    least = std::min(least, point[0]);
    greatest = std::max(greatest, point[0]);
  }
  EXPECT_LT(least, -0.01) << "grease that gets stiff";
  EXPECT_GT(greatest, 0.05);
  for (const auto& point : gridOf(unknownsOf(*twin::findEffect("torque_limit")))) {
    strictest = std::min(strictest, point[0]);
    mildest = std::max(mildest, point[0]);
  }
  EXPECT_LT(strictest, 0.35);
  EXPECT_GT(mildest, 0.95) << "1 is not a limit";
  EXPECT_LT(mildest, 1);
}

FittedModel effectOn(const Study& study, std::string_view effect) {
  return fitWith(study, {{twin::findEffect(effect)}}, Nuisance::kFixed);
}

TEST(CrossValidation, WhatIsMissingHelpsOnLogsThatWereNotFitted) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 25);
  const Study study{given};
  const CrossValidation validation =
      crossValidate(baselineOn(study, Nuisance::kFixed), effectOn(study, "encoder_offset"));
  EXPECT_EQ(validation.logs, 3);
  EXPECT_TRUE(validation.improves());
  EXPECT_GT(validation.mean, std::log(2));
  const FittedModel with = effectOn(study, "encoder_offset");
  EXPECT_FALSE(mayBeNone(with, with.effects.front()));
}

TEST(CrossValidation, WhatIsNotThereDoesNot) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 26);
  const Study study{given};
  EXPECT_FALSE(crossValidate(baselineOn(study, Nuisance::kFixed), effectOn(study, "supply_sag")).improves());
}

TEST(CrossValidation, ARarerEffectHasToExceedAMargin) {
  const CrossValidation surely{.mean = 0.15, .error = 0.02, .logs = 8}, hardly{.mean = 0.15, .error = 0.05, .logs = 8};
  EXPECT_TRUE(surely.improvesBy(0.1));
  EXPECT_TRUE(hardly.improves());
  EXPECT_FALSE(hardly.improvesBy(0.1));
  EXPECT_FALSE((CrossValidation{.mean = 0.95, .error = 0.5, .logs = 8}.improvesBy(0.1))) << "nor by nothing";
}

// Its number comes from that log: a fit to the others knows nothing of it.
TEST(CrossValidation, ALogThatAloneShowsAnEffectIsNotPredictedByIt) {
  Case bench = smallBench();
  for (Trajectory& log : bench.logs) log.held_out = true;
  for (double (*const slow)(double) :
       {+[](double t) { return 0.3 * std::sin(t); }, +[](double t) { return 0.2 * std::sin(2 * t); },
        +[](double t) { return 0.25 * std::sin(1.5 * t); }})
    bench.logs.push_back(commanded("slow", 4, 16, 0.3, slow));
  bench.logs.push_back(commanded("steps", 4, 32, 0.3, [](double t) { return t < 1 ? 0.0 : t < 2.5 ? 1.2 : -0.6; }));
  const Case given = measured(bench, withEffect(bench, "torque_limit", "duty", 0.35), 28);
  const Study study{given};
  const FittedModel bare = baselineOn(study, Nuisance::kFixed), limited = effectOn(study, "torque_limit");
  ASSERT_LT(limited.fit.cost, 0.5 * bare.fit.cost);
  const std::vector<double> without = leaveOneOutErrors(bare), with = leaveOneOutErrors(limited);
  EXPECT_GT(without[3], 0.01);
  EXPECT_NEAR(with[3], without[3], 0.02 * without[3]);
  const std::optional<Eigen::VectorXd> half_widths = halfWidthsByLogs(limited);
  ASSERT_TRUE(half_widths);
  EXPECT_TRUE(std::isinf((*half_widths)[0])) << "the logs do not say how far they would disagree";
  EXPECT_TRUE(mayBeNone(limited, limited.effects.front()));
  EXPECT_FALSE(halfWidthsByLogs(bare)) << "nothing was fitted";
}

TEST(CrossValidation, ALogThatTheEncoderCannotTellFromAnotherDoesNotCount) {
  constexpr double kFloor = 4e-4;
  EXPECT_TRUE(crossValidate({0.1, 0.11, 0.1, 0}, {0.02, 0.02, 0.021, 0}, kFloor).improves()) << "an arm at rest";
  EXPECT_NEAR(crossValidate({1e-5, 1e-5, 1e-5}, {1e-7, 1e-7, 1e-7}, kFloor).mean, 0, 0.001);
}

TEST(CrossValidation, ALogAndItsRepeatsAreLeftOutTogether) {
  const Case bench = smallBench();
  Case given = measured(bench, baselineOf(bench), 25);
  given.logs.push_back(measured(bench, baselineOf(bench), 26).logs[0]);
  given.logs.back().repeat_of = 0;
  const Study study{given, {.runs = 2, .disturbance = {}}};
  const FittedModel fitted = baselineOn(study, Nuisance::kFixed);
  ASSERT_EQ(fitted.evidence->logs.size(), 4U);
  EXPECT_EQ(independentLogs(*fitted.evidence), (std::vector<std::vector<std::size_t>>{{0, 3}, {1}, {2}}));
  EXPECT_EQ(leaveOneOutErrors(fitted).size(), 3U);
}

TEST(Estimates, ARemainderWidensByTheTimeThatErrorsAreCorrelated) {
  const Case bench = smallBench();
  const twin::EffectInfo& offset = *twin::findEffect("encoder_offset");
  Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 24);
  given.logs[2].held_out = true;  // two logs: no jackknife
  const Study study{given};
  const FittedModel fitted = fitWith(study, {{&offset}}, Nuisance::kFixed, 2);
  const auto widthFor = [&](double excess) {
    const Estimate one = estimatesOf(fitted, offset, excess).front();
    return one.high - one.low;
  };
  const double right = widthFor(1);
  EXPECT_NEAR(widthFor(2) / right, std::sqrt(2 * 8), 0.01) << "rows of 16 ms";
  for (Trajectory& log : given.logs)
    for (double& time_s : log.time_s) time_s /= 4;
  EXPECT_NEAR(widthFor(2) / right, std::sqrt(2 * 4 * 8), 0.01);
}

// A standard error of three values: 90 % of means are within 2.92 of it.
TEST(Estimates, ThreeLogsThatDisagreeGiveTheIntervalOfThreeLogs) {
  const Case bench = smallBench();
  const twin::EffectInfo& offset = *twin::findEffect("encoder_offset");
  Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 24);
  for (std::size_t log = 0; log < 3; ++log)
    for (double& position : given.logs[log].position_rad) position += 0.001 * (static_cast<double>(log) - 1);
  const auto estimate = [&] {
    const Study study{given};
    return estimatesOf(fitWith(study, {{&offset}}, Nuisance::kFixed, 2), offset, 2).front();
  };
  const Estimate all = estimate();
  double square_sum = 0;
  for (std::size_t left_out = 0; left_out < 3; ++left_out) {
    given.logs[left_out].held_out = true;
    square_sum += std::pow(estimate().value - all.value, 2);
    given.logs[left_out].held_out = false;
  }
  const double jackknife = std::sqrt(square_sum * 2 / 3);
  const double half = (all.high - all.low) / 2;  // its own jackknife is of first order
  EXPECT_GT(half, 2.92 * 0.9 * jackknife);
  EXPECT_LT(half, 2.92 * 1.5 * jackknife);
}

TEST(Estimates, WhatTheDataSayNothingAboutIsLeftNeutral) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "torque_limit", "duty", 0.6), 24);
  const twin::EffectInfo& limit = *twin::findEffect("torque_limit");
  const Study study{given};
  const FittedModel fitted = fitWith(study, {{&limit}}, Nuisance::kFixed, 2);
  const std::vector<Estimate> estimates = estimatesOf(fitted, limit, 1);
  ASSERT_EQ(estimates.size(), 2U);
  EXPECT_TRUE(estimates[0].seen);
  EXPECT_NEAR(estimates[0].value, 0.6, 0.01);
  EXPECT_FALSE(estimates[1].seen) << "a torque that the motor never reaches limits nothing";
  EXPECT_EQ(withoutUndetermined(fitted).find("torque_limit")->values[1], limit.parameters[1].neutral);
}

}  // namespace
}  // namespace darwinop::gap
