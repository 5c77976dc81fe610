// Calibrated noise; unknowns are found by the fit.
#include <gtest/gtest.h>

#include "gap/fit/jacobian.hpp"
#include "gap/fit/solve.hpp"
#include "gap/plant/registers.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

double share(const Eigen::VectorXd& residuals) {
  return residuals.unaryExpr(&costOf).sum() / static_cast<double>(residuals.size());
}

Eigen::VectorXd residualsOf(const Case& bench) {
  const Evidence evidence = evidenceOf(plantOf(bench), bench, baselineOf(bench));
  const Problem problem{evidence, baselineOf(bench), {}};
  Eigen::VectorXd residuals(evidence.size());
  problem.residuals({}, residuals);
  return residuals;
}

TEST(Nuisances, EveryPriorThatACaseMayHaveMovesANumber) {
  Case bench = smallBench();
  bench.logs[1].arm_mass_kg = 0.06;
  bench.priors = {{"arm_mass", 0.2}, {"back_emf", 0.1}, {"speed_gain_per_kp", 0.1}};
  const Hypothesis baseline = baselineOf(bench);
  const std::vector<Unknown> unknowns = nuisancesOf(bench, baseline);
  ASSERT_EQ(unknowns.size(), 3U);
  const std::vector<double> moved(3, 1.1);
  const Hypothesis other = applied(baseline, unknowns, moved.data());
  EXPECT_DOUBLE_EQ(other.servo.back_emf_vs_rad, 1.1 * baseline.servo.back_emf_vs_rad);
  EXPECT_DOUBLE_EQ(other.servo.speed_gain_per_kp_1_s, 1.1 * baseline.servo.speed_gain_per_kp_1_s);
  EXPECT_DOUBLE_EQ(armOf(bench, bench.logs[0], other).arm_mass_kg, 1.1 * 0.03);
  EXPECT_DOUBLE_EQ(armOf(bench, bench.logs[1], other).arm_mass_kg, 1.1 * 0.06) << "of this log's own arm";
  EXPECT_DOUBLE_EQ(*withModel(bench, other).logs[1].arm_mass_kg, 1.1 * 0.06);
}

TEST(Noise, ARightModelCostsAboutOneASample) {
  const Case bench = smallBench();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const double cost = share(residualsOf(measured(bench, baselineOf(bench), seed)));
    EXPECT_GT(cost, 0.5) << seed;
    EXPECT_LT(cost, 1.1) << seed;
  }
}

TEST(Noise, AWrongModelCostsMore) {
  const Case bench = smallBench();
  EXPECT_GT(share(residualsOf(measured(bench, withEffect(bench, "encoder_offset", "offset", 0.01), 1))), 1.5);
}

TEST(Noise, UnknownSamplesDoNotCount) {
  Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  for (double& load : bench.logs[0].load) load = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(residualsOf(bench).allFinite());
}

// Costs under the noise of different hypotheses are compared by it.
TEST(Noise, UnknownSamplesHaveNoPartInTheDeterminant) {
  Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  bench.logs.resize(1);
  const auto determinant = [&] {
    return evidenceOf(plantOf(bench), bench, baselineOf(bench)).noise[0].logDeterminant();
  };
  const double all = determinant();
  for (double& load : bench.logs[0].load) load = std::numeric_limits<double>::quiet_NaN();
  const double positions = determinant();
  EXPECT_NEAR(positions / all, 0.5, 0.1);
  const std::size_t half = bench.logs[0].rows() / 2;
  for (std::size_t row = 0; row < half; ++row)
    bench.logs[0].position_rad[2 * row + 1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(determinant() / positions, 0.5, 0.1);
  const RmsSum floor = evidenceOf(plantOf(bench), bench, baselineOf(bench)).noise[0].positionFloor();
  EXPECT_EQ(floor.rows, static_cast<double>(bench.logs[0].rows() - half));
  EXPECT_LT(floor.rms(), 0.01);
}

TEST(Noise, LoadsOfWholePercentAreKnownToThat) {
  Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  EXPECT_NEAR(loadStepOf(bench.logs[0]), kLoadStep, 1e-9);
  const double fine = share(residualsOf(bench));
  for (Trajectory& log : bench.logs)
    for (double& load : log.load) load = std::round(load * 100) / 100;
  EXPECT_NEAR(loadStepOf(bench.logs[0]), 0.01, 1e-9);
  EXPECT_LT(share(residualsOf(bench)), 1.2 * fine) << "rounding is noise, not a gap";
}

TEST(Noise, TheFloorIsAtLeastWhatTheEncoderRounds) {
  const Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  const double tick = 2 * 3.14159265 / 4096;
  for (const LogNoise& log : evidenceOf(plantOf(bench), bench, baselineOf(bench)).noise) {
    EXPECT_GE(log.positionSigma().minCoeff(), 0.4 * tick);
    EXPECT_LT(log.positionSigma().minCoeff(), 0.6 * tick) << "the arm stands still somewhere";
  }
}

TEST(Solve, FindsAMovedNumberAndItsInterval) {
  const Case bench = smallBench();
  Hypothesis truth = baselineOf(bench);
  truth.servo.kt_nm_a *= 1.03;
  truth.servo.back_emf_vs_rad *= 1.03;
  const Case given = measured(bench, truth, 4);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  std::vector<Unknown> unknowns;
  for (Unknown& unknown : nuisancesOf(given, baselineOf(given)))
    if (unknown.name == "kt") unknowns.push_back(unknown);
  ASSERT_EQ(unknowns.size(), 1U);
  const Problem problem{evidence, baselineOf(given), unknowns};
  const Fit fit = solve(problem, problem.expected());
  const double sigma = std::sqrt(fit.covariance(0, 0));
  EXPECT_NEAR(fit.x[0], 1.03, 4 * sigma);
  EXPECT_GT(sigma, 1e-5);
  EXPECT_LT(sigma, 0.005) << "the logs, not the prior of 2 %, determine it";
  EXPECT_LE(fit.cost, problem.cost(problem.expected()));
}

TEST(Solve, GivesTheJacobianOfItsEndAndItsSteps) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 5);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const Problem problem{evidence, baselineOf(given), nuisancesOf(given, baselineOf(given))};
  for (const int iterations : {0, 1, 12}) {
    const Fit fit = solve(problem, problem.expected(), {.iterations = iterations});
    EXPECT_EQ(fit.jacobian, jacobianAt(problem, fit.x, fit.residuals, fit.steps)) << iterations;
  }
  EXPECT_EQ(solve(problem, problem.expected(), {.refine = false}).jacobian.size(), 0) << "none was wanted";
}

TEST(Solve, TakesNoJacobianAtAStartWhereItIsKnown) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "encoder_offset", "offset", 0.03), 3);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const Problem problem{evidence, baselineOf(given), unknownsOf(*twin::findEffect("encoder_offset"))};
  const Eigen::VectorXd start = problem.inBounds(problem.expected());
  SolveOptions options{.refine = false};
  const Fit found = solve(problem, start, options);
  Eigen::VectorXd residuals(evidence.size());
  problem.residuals(start, residuals);
  options.jacobian = jacobianAt(problem, start, residuals, firstSteps(problem));
  EXPECT_EQ(solve(problem, start, options).x, found.x);
  options.jacobian *= -1;  // which leads nowhere
  EXPECT_NE(solve(problem, start, options).x, found.x);
}

TEST(Solve, BeginsWithinTheBounds) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 5);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const Problem problem{evidence, baselineOf(given), unknownsOf(*twin::findEffect("coulomb"))};
  const Unknown& friction = problem.unknowns()[0];
  const Fit fit = solve(problem, Eigen::VectorXd::Constant(1, friction.toSearch(friction.low) - 1),
                        {.iterations = 0, .refine = false});
  EXPECT_EQ(fit.x[0], friction.toSearch(friction.low));
}

TEST(Problem, StopsWhereACostExceedsItsBound) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 7);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const Problem problem{evidence, baselineOf(given), nuisancesOf(given, baselineOf(given))};
  const Eigen::VectorXd x = problem.expected();
  Eigen::VectorXd all(evidence.size());
  problem.residuals(x, all);
  const double cost = all.unaryExpr(&costOf).sum() + problem.priorCost(x);
  EXPECT_NEAR(problem.cost(x), cost, 1e-9 * cost);
  const std::vector<std::size_t> order = problem.costliestFirst(all);
  EXPECT_NEAR(problem.costUpTo(1.001 * cost, x, order), cost, 1e-9 * cost);
  EXPECT_TRUE(std::isinf(problem.costUpTo(0.999 * cost, x, order)));
  EXPECT_TRUE(std::isinf(problem.costUpTo(-1, x, order)));
  double before = cost;
  for (const std::size_t log : order) {
    const double here = problem.costUpTo(2 * cost, x, {log}) - problem.priorCost(x);
    EXPECT_LE(here, before) << "log " << log;
    before = here;
  }
}

// Torque constant, resistance, payload and length together leave hardly a trace, and what is left of the sum of their
// derivatives is mostly the curvature of the steps, unless a step goes along that valley.
TEST(Jacobian, IsExactAlongAFlatValley) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 6);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const Problem problem{evidence, baselineOf(given), nuisancesOf(given, baselineOf(given))};
  const Eigen::VectorXd x = problem.expected();
  Eigen::VectorXd here(evidence.size()), there(evidence.size());
  problem.residuals(x, here);
  const Eigen::MatrixXd first = jacobianAt(problem, x, here, firstSteps(problem));
  const Eigen::MatrixXd along = stepsAlong(problem, first.transpose() * first);
  const Eigen::VectorXd move = along.col(0) / 2;  // the direction that the data see least
  problem.residuals(x + move, there);
  const auto error = [&](const Eigen::MatrixXd& jacobian) {
    return (jacobian * move - (there - here)).norm() / (there - here).norm();
  };
  EXPECT_LT(error(jacobianAt(problem, x, here, along)), 0.35);
  EXPECT_GT(error(first), 1) << "otherwise the second pass is not needed";
}

// Goals that come a period later or earlier make the cost discontinuous.
TEST(Solve, FindsADelayFromPeriodsAway) {
  const Case bench = smallBench();
  const Case given = measured(bench, withEffect(bench, "transport_delay", "delay", 0.0292), 7);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  const twin::EffectInfo& delay = *twin::findEffect("transport_delay");
  Hypothesis with = baselineOf(given);
  with.with(delay);
  const Problem problem{evidence, with, unknownsOf(delay)};
  for (const double begin : {0.025, 0.031, 0.034}) {
    const Fit fit = solve(problem, Eigen::VectorXd::Constant(1, problem.unknowns()[0].toSearch(begin)));
    EXPECT_NEAR(problem.unknowns()[0].fromSearch(fit.x[0]), 0.0292, 0.0005) << begin;
  }
}

TEST(Solve, AnUnknownThatChangesNothingHasNoCovariance) {
  const Case given = measured(smallBench(), baselineOf(smallBench()), 5);
  const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given));
  // A ripple without amplitude: its phase cannot be known.
  Hypothesis flat = baselineOf(given);
  flat.with(*twin::findEffect("cogging"));
  const Problem problem{evidence, flat, {unknownsOf(*twin::findEffect("cogging")).at(2)}};
  const Fit fit = solve(problem, problem.expected());
  EXPECT_FALSE(std::isfinite(fit.covariance(0, 0)));
}

TEST(Unknowns, AreTheNumbersWithPriors) {
  const Case bench = smallBench();
  std::vector<std::string> names;
  for (const Unknown& unknown : nuisancesOf(bench, baselineOf(bench))) names.push_back(unknown.name);
  EXPECT_EQ(names, (std::vector<std::string>{"kt", "resistance", "armature", "payload", "length"}));
  Case slow = bench;
  slow.model.servo.law = twin::Law::kSpeedP;  // has no motor constants
  names.clear();
  for (const Unknown& unknown : nuisancesOf(slow, baselineOf(slow))) names.push_back(unknown.name);
  EXPECT_EQ(names, (std::vector<std::string>{"armature", "payload", "length"}));
}

}  // namespace
}  // namespace darwinop::gap
