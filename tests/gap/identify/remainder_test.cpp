// What an answer says where a remainder is left: which names stay, which are withdrawn, and why.
#include <gtest/gtest.h>

#include <array>

#include "gap/identify/assessment.hpp"
#include "gap/identify/held_out.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

/// Dry friction that is accepted, and a rival that is so far behind in evidence.
Identification frictionWithRival(double behind) {
  Identification found;
  found.effects.push_back({.effect = twin::findEffect("coulomb"), .estimates = {}});
  found.rivals.push_back({.effects = {"deadband"}, .behind = behind});
  return found;
}

TEST(Remainder, ACloseRivalIsAmbiguousOnARoughBaselineToo) {
  EXPECT_EQ(verdictOfRough(frictionWithRival(0), 0.1, 0.01), Verdict::kAmbiguous);
  EXPECT_EQ(verdictOfRough(frictionWithRival(50), 0.1, 0.01), Verdict::kNamed);
  EXPECT_EQ(verdictOfRough(frictionWithRival(50), 0.1, 0.04), Verdict::kNamed) << "with a remainder";
  EXPECT_EQ(verdictOfRough(frictionWithRival(0), 0.1, 0.05), Verdict::kUnknown) << "half of the error is left";
}

TEST(Remainder, AnErrorThatGrowsWithinNoiseIsNotWorse) {
  EXPECT_TRUE(isWorse(0.010, 0.020, 0.001));
  EXPECT_FALSE(isWorse(0.001, 0.0015, 0.001)) << "half a floor";
  EXPECT_FALSE(isWorse(0.100, 0.102, 0.001)) << "2 %";
  EXPECT_FALSE(isWorse(std::nan(""), std::nan(""), 0.001)) << "no log is held out";
}

/// A fit of these effects, each at one value.
FittedModel fittedAt(const Study& study, const std::vector<std::pair<std::string_view, double>>& values) {
  Effects effects;
  for (const auto& [id, value] : values) effects.push_back({twin::findEffect(id)});
  const Problem problem = problemWith(study, study.evidence, effects, Nuisance::kFree);
  Fit start;
  start.x = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i)
    for (const auto& [id, value] : values)
      if (problem.unknowns()[i].name.starts_with(std::string{id} + "."))
        start.x[static_cast<Eigen::Index>(i)] = problem.unknowns()[i].toSearch(value);
  return refit(study, effects, Nuisance::kFree, problem, start, 1);
}

// The fitted logs do not count: only the held-out one vouches for a name.
TEST(Remainder, HeldOutLogsVouchForEachEffectThatTheyNeed) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "coulomb", "friction", 0.06), 41);
  const Study study{given};
  EXPECT_TRUE(predictsHeldOut(fittedAt(study, {{"coulomb", 0.06}})));
  EXPECT_FALSE(predictsHeldOut(fittedAt(study, {{"coulomb", 0.06}, {"encoder_offset", 0.0005}})))
      << "without the second effect these logs are predicted as well";
  Case alone = given;
  alone.logs.pop_back();
  const Study nothing_held_out{alone};
  EXPECT_FALSE(predictsHeldOut(fittedAt(nothing_held_out, {{"coulomb", 0.06}})));
}

// The released arm rubs more than the powered one, which no single friction explains.
TEST(Remainder, IntervalsAreAsWideAsTheLogsDisagree) {
  const Case bench = smallBench();
  Case given = measured(bench, withEffect(bench, "coulomb", "friction", 0.05), 41);
  given.logs[2] = measured(bench, withEffect(bench, "coulomb", "friction", 0.08), 41).logs[2];
  const Study study{given};
  const FittedModel fitted = fittedAt(study, {{"coulomb", 0.06}});
  const Estimate friction = estimatesOf(fitted, *twin::findEffect("coulomb"), 10).front();
  EXPECT_LT(friction.low, 0.052);
  EXPECT_GT(friction.high, 0.078);
  const Estimate of_right_model = estimatesOf(fitted, *twin::findEffect("coulomb"), 1).front();
  EXPECT_LT(of_right_model.high - of_right_model.low, 0.01);
}

/// Prior conflicts in three logs of arms whose lengths are these multiples of the given one, of a roughly known motor.
std::vector<PriorConflict> conflictsWith(const std::array<double, 3>& factors) {
  Case given = smallBench();
  given.priors = {{"length", 0.01}, {"kt", 0.15}};
  for (std::size_t log = 0; log < 3; ++log) {
    Case other = smallBench();
    other.pendulum.length_m *= factors.at(log);
    given.logs[log] = measured(other, baselineOf(other), 41).logs[log];
  }
  const Study study{given};
  const FittedModel fitted = fittedAt(study, {});
  EXPECT_GT(largestPriorSigma(fitted), thresholds::kPriorConflictSigmas);
  return priorConflictsOf(fitted);
}

TEST(Conflict, IsANumberThatAllLogsPullOutOfItsPrior) {
  const std::vector<PriorConflict> conflicts = conflictsWith({1.06, 1.06, 1.06});
  ASSERT_EQ(conflicts.size(), 1U);
  EXPECT_EQ(conflicts[0].number, "length");
  EXPECT_NEAR(conflicts[0].factor, 1.06, 0.01);
  for (const PriorConflict& one : conflictsWith({1.15, 1, 1})) ADD_FAILURE() << one.number << ", pulled by one log";
}

// Without the effect, the number of the baseline itself would take its value, however improbable that is.
TEST(Remainder, AnEffectBeyondThePriorOfItsNumberIsNeeded) {
  Case bench = smallBench();
  bench.priors.push_back({"viscous.damping", 0.1});
  const Case given = measured(bench, withEffect(bench, "viscous", "damping", 0.06), 41);
  const Study study{given};
  EXPECT_TRUE(predictsHeldOut(fittedAt(study, {{"viscous", 0.06}})));
}

}  // namespace
}  // namespace darwinop::gap
