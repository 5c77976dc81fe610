// Who is suspected, before any fit.
#include "gap/name/screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gap/name/grid.hpp"
#include "gap/name/judge.hpp"
#include "gap/name/ripple.hpp"
#include "gap/name/unseen.hpp"
#include "small_case.hpp"

namespace darwinop::gap {
namespace {

Settled nothingSaid(const Case& given, Numbers numbers) {
  const Evidence evidence = evidenceOf(given, baselineOf(given));
  const Problem problem = problemWith(evidence, {}, numbers);
  Fit start;
  start.x = problem.expected();
  return settle({}, numbers, problem, start, 1);
}

TEST(Judge, ANumberWithinItsPriorHasToGainWhatAnyEffectHasTo) {
  const Case bench = smallBench();  // its payload is known to 1 %
  const auto least = [&](const char* effect, const char* key, double value) {
    return leastGain(bench, withEffect(bench, effect, key, value), *twin::findEffect(effect), 16);
  };
  EXPECT_EQ(least("com_mass", "mass", 0.01), 16);
  EXPECT_EQ(least("com_mass", "mass", -0.05), kStrainGain);
  EXPECT_EQ(least("viscous", "damping", 0.02), 16) << "nobody has said how well it is known";
  EXPECT_EQ(least("encoder_offset", "offset", 0.05), 16);
}

const twin::EffectInfo* const kSuspects[] = {twin::findEffect("encoder_offset"), twin::findEffect("transport_delay"),
                                             twin::findEffect("supply_sag")};

TEST(Screen, WhatIsMissingPromisesMost) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 21);
  const Settled present = nothingSaid(given, Numbers::kHeld);
  const Screen screen{present, {std::begin(kSuspects), std::end(kSuspects)}};
  EXPECT_EQ(screen.probes().front().effect->id, "encoder_offset");
  EXPECT_GT(screen.probes().front().promise, 100);
}

TEST(Screen, ASharpenedProbeIsWhereTheTruthIs) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 22);
  const Settled present = nothingSaid(given, Numbers::kFree);
  const Screen screen{present, {twin::findEffect("encoder_offset")}};
  const Probe first = screen.probes().front();
  const Sharpened sharp = screen.sharpened(first);
  EXPECT_NEAR(sharp.probe.values[0], 0.03, 0.003);
  EXPECT_GT(sharp.probe.promise, 0.9 * first.promise);
}

TEST(Screen, NoisePromisesLittle) {
  const Case bench = smallBench();
  const Case given = measured(bench, baselineOf(bench), 23);
  const Settled present = nothingSaid(given, Numbers::kHeld);
  const Screen screen{present, {std::begin(kSuspects), std::end(kSuspects)}};
  EXPECT_LT(screen.probes().front().promise, 30);
  EXPECT_LT(screen.greatestPromise(Eigen::VectorXd::Zero(present.evidence->size())), 1e-9);
}

// With 0.06 N m sixteen times a turn, an arm comes to rest in other dips than without: what is linear over a whole log
// has nothing to say.
TEST(Screen, ARippleIsSeenInShortWindows) {
  const Case bench = smallBench();
  Hypothesis truth = baselineOf(bench);
  truth.with(*twin::findEffect("cogging")).values = {0.06, 16, -1.46};
  const Case given = measured(bench, truth, 27);
  const std::vector<Probe> ripples = ripplesOf(nothingSaid(given, Numbers::kHeld));
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
  EXPECT_GT(mildest, 0.95) << "1 is no limit";
  EXPECT_LT(mildest, 1);
}

Settled settledWith(const Case& given, std::string_view effect) {
  const twin::EffectInfo& info = *twin::findEffect(effect);
  const Evidence evidence = evidenceOf(given, baselineOf(given));
  const Problem problem = problemWith(evidence, {{&info}}, Numbers::kHeld);
  Fit start;
  start.x = problem.expected();
  return settle({{&info}}, Numbers::kHeld, problem, start, 1);
}

TEST(Foretold, WhatIsMissingHelpsOnLogsThatWereNotFitted) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 25);
  const Foretold told = foretold(nothingSaid(given, Numbers::kHeld), settledWith(given, "encoder_offset"));
  EXPECT_EQ(told.logs, 3);
  EXPECT_TRUE(told.better());
  EXPECT_GT(told.mean, std::log(2));
}

TEST(Foretold, WhatIsNotThereDoesNot) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 26);
  EXPECT_FALSE(foretold(nothingSaid(given, Numbers::kHeld), settledWith(given, "supply_sag")).better());
}

TEST(Estimates, WhatTheDataSayNothingAboutIsLeftNeutral) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "torque_limit", "duty", 0.6), 24);
  const twin::EffectInfo& limit = *twin::findEffect("torque_limit");
  const Evidence evidence = evidenceOf(given, baselineOf(given));
  const Problem problem = problemWith(evidence, {{&limit}}, Numbers::kHeld);
  Fit start;
  start.x = problem.expected();
  const Settled fitted = settle({{&limit}}, Numbers::kHeld, problem, start, 2);
  const std::vector<Estimate> estimates = estimatesOf(fitted, limit, 1);
  ASSERT_EQ(estimates.size(), 2U);
  EXPECT_TRUE(estimates[0].seen);
  EXPECT_NEAR(estimates[0].value, 0.6, 0.01);
  EXPECT_FALSE(estimates[1].seen) << "a torque that the motor never reaches limits nothing";
  EXPECT_EQ(withoutUnseen(fitted).find("torque_limit")->values[1], limit.parameters[1].neutral);
}

}  // namespace
}  // namespace darwinop::gap
