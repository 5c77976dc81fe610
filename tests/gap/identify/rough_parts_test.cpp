// What the search on a roughly known baseline asks of logs, voltages and noise.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "gap/fit/discrepancy.hpp"
#include "gap/identify/cross_validation.hpp"
#include "gap/identify/fitted_model.hpp"
#include "gap/identify/shown.hpp"
#include "gap/identify/supply_check.hpp"
#include "gap/manual_bench.hpp"

namespace darwinop::gap {
namespace {

TEST(EffectsNotShown, AreThoseWithNoneOfTheirFeatures) {
  Case bench = smallBench();
  bench = measured(bench, baselineOf(bench), 1);
  EXPECT_TRUE(isShown(bench, "coulomb")) << "a release";
  EXPECT_FALSE(isShown(bench, "load_dependent_friction")) << "one payload";
  EXPECT_TRUE(isShown(bench, "inertia")) << "every motion shows it";
  bench.logs.front().payload_kg = 0.6;
  EXPECT_TRUE(isShown(bench, "load_dependent_friction"));
}

NoiseOptions fewRuns() {
  NoiseOptions options;
  options.runs = 4;
  return options;
}

/// A fit that says the supply has so many ohm.
FittedModel sagging(const Study& study, double ohm) {
  auto evidence = std::make_shared<const Evidence>(study.evidence);
  const Effects effects{{twin::findEffect("supply_sag")}};
  Problem problem = problemWith(study, *evidence, effects, Nuisance::kFixed);
  Fit fit;
  fit.x = problem.expected();
  fit.x[0] = problem.unknowns()[0].toSearch(ohm);
  return {&study, effects, Nuisance::kFixed, std::move(evidence), std::move(problem), std::move(fit), 0};
}

TEST(Voltage, ThatStaysUpContradictsASupplyThatSags) {
  const Case bench = manualBench();
  const Case given = measuredIn({.torque_nm = 0}, bench, baselineOf(bench));
  EXPECT_TRUE(contradictsVoltage(sagging(Study{given, fewRuns()}, 3)));
  EXPECT_FALSE(contradictsVoltage(sagging(Study{given, fewRuns()}, 0.3))) << "wires have as much";
}

TEST(Voltage, ThatDipsAllowsIt) {
  const Case bench = manualBench();
  const Case given = measuredIn({.torque_nm = 0}, bench, withEffect(bench, "supply_sag", "resistance", 3));
  EXPECT_FALSE(contradictsVoltage(sagging(Study{given, fewRuns()}, 3)));
}

TEST(Voltage, ThatNobodyMeasuredSaysNothing) {
  const Case bench = manualBench();
  Case given = measuredIn({.torque_nm = 0}, bench, baselineOf(bench));
  for (Trajectory& log : given.logs) log.volt_v.assign(log.rows(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(contradictsVoltage(sagging(Study{given, fewRuns()}, 3)));
}

TEST(PredictionErrors, AreThoseOfEachLogByItself) {
  const Case bench = manualBench();
  Case given = measuredIn({.torque_nm = 0}, bench, baselineOf(bench));
  for (double& position : given.logs[1].position_rad) position += 0.02;
  given.logs[1].position_rad[5] = std::numeric_limits<double>::quiet_NaN();  // masked
  const std::vector<double> errors = predictionErrors(plantOf(given), given, baselineOf(given));
  ASSERT_EQ(errors.size(), given.logs.size());
  EXPECT_LT(errors[0], 0.003);
  EXPECT_NEAR(errors[1], 0.02, 0.003);
}

TEST(PredictionErrors, OfWhatIsImpossibleAreLarge) {
  Case given = manualBench();
  for (Trajectory& log : given.logs) log.position_rad = log.goal_rad;
  const Hypothesis no_inertia = withEffect(given, "inertia", "change", -1);
  for (const double error : predictionErrors(plantOf(given), given, no_inertia)) EXPECT_GT(error, 3);
}

TEST(Discrepancy, IsWhatMostSamplesAreOffBy) {
  const Case bench = manualBench();
  Case given = measuredIn({.torque_nm = 0}, bench, baselineOf(bench));
  const std::vector<std::size_t> logs{0, 1};
  const double before = discrepancyOf(plantOf(given), given, logs, baselineOf(given)).position_rad;
  EXPECT_LT(before, 0.003);
  for (double& position : given.logs[0].position_rad) position += 0.02;
  for (double& position : given.logs[1].position_rad) position -= 0.02;
  for (std::size_t row = 0; row < 20; ++row) given.logs[0].position_rad[row] += 1;  // a hand on the arm
  EXPECT_NEAR(discrepancyOf(plantOf(given), given, logs, baselineOf(given)).position_rad, 1.4826 * 0.02, 0.003);
}

TEST(Discrepancy, NeighboursCountAsOne) {
  const Case bench = manualBench();
  const Case given = measuredIn({.torque_nm = 0}, bench, baselineOf(bench));
  NoiseOptions bearing = fewRuns();
  bearing.discrepancy = {
      .position_rad = 0.02, .load = std::vector<double>(given.logs.size(), 0.01), .correlation_s = 20 * kRow};
  Hypothesis off = baselineOf(given);
  off.pendulum.length_m *= 1.005;
  const auto cost = [&](const NoiseOptions& options) {
    const Evidence evidence = evidenceOf(plantOf(given), given, baselineOf(given), LogRole::kFit, options);
    return Problem{evidence, off, {}}.cost({});
  };
  NoiseOptions alone = bearing;
  alone.discrepancy.correlation_s = kRow;
  EXPECT_NEAR(cost(alone) / cost(bearing), 20, 0.5);
}

TEST(Discrepancy, FarSamplesCountLinearly) {
  EXPECT_NEAR(softened(0.1), 0.1, 1e-3);
  EXPECT_DOUBLE_EQ(softened(-3), -softened(3));
  const auto cost = [](double residual) { return std::pow(softened(residual), 2); };
  EXPECT_NEAR(cost(200) - cost(199), cost(100) - cost(99), 1e-3);
  EXPECT_GT(softened(3.01), softened(3));
}

}  // namespace
}  // namespace darwinop::gap
