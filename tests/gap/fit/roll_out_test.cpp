// A log run again on a model.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "core/conversions.hpp"
#include "gap/case/parts.hpp"
#include "gap/fit/unknown.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/plant/write_instant.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

Trace traceOf(const Case& bench, std::size_t log, const Hypothesis& model, const Disturbance* disturbance = nullptr) {
  Trace trace;
  rollOut(bench, log, model, {.disturbance = disturbance}, trace);
  return trace;
}

std::size_t firstRowBeyond(const std::vector<double>& values, double limit) {
  for (std::size_t row = 0; row < values.size(); ++row)
    if (std::abs(values[row] - values[0]) > limit) return row;
  return values.size();
}

TEST(RollOut, AGoalWrittenBeforeTheReadActsOneRowEarlier) {
  Case bench = smallBench();
  bench.logs[0].position_rad.assign(bench.logs[0].rows(), 0);
  const std::size_t after = firstRowBeyond(traceOf(bench, 0, baselineOf(bench))[kLoadSignal], 0.1);
  bench.goal_order = GoalOrder::kBeforeRead;
  Hypothesis model = baselineOf(bench);
  model.written_before_s = kRow;
  const std::size_t before = firstRowBeyond(traceOf(bench, 0, model)[kLoadSignal], 0.1);
  EXPECT_EQ(after, before + 1);
}

TEST(RollOut, AWriteBetweenTwoReadsMovesTheAnswerBySmallSteps) {
  Case bench = smallBench();
  bench.logs[1].position_rad = bench.logs[1].goal_rad;
  bench.goal_order = GoalOrder::kBeforeRead;
  Hypothesis model = baselineOf(bench);
  EXPECT_NEAR(model.written_before_s, kRow / 2, 1e-9) << "nothing is known";
  const auto position_at = [&](double before_s) {
    model.written_before_s = before_s;
    return traceOf(bench, 1, model)[kPositionSignal][100];  // on its way, at 0.9 rad/s
  };
  constexpr double kStep = 0.00025;  // s, a quarter of the firmware's period
  for (double before_s = 0.001; before_s < 0.014; before_s += kStep)
    EXPECT_NEAR(position_at(before_s + kStep) - position_at(before_s), 0.9 * kStep, 0.2 * 0.9 * kStep) << before_s;
}

TEST(RollOut, ServosReadAtAnyPhaseAreOnAverageWhereTheirMeanIs) {
  Case bench = smallBench();
  bench.logs[1].position_rad = bench.logs[1].goal_rad;
  bench.goal_order = GoalOrder::kBeforeRead;
  const Hypothesis model = baselineOf(bench);
  const std::vector<double> mean = traceOf(bench, 1, model)[kPositionSignal];
  constexpr std::size_t kServos = 400, kFirst = 60;  // rows; the arm is on its way
  std::vector<double> apart(mean.size());
  for (std::size_t servo = 0; servo < kServos; ++servo) {
    const Disturbance rounding{.seed = 40 + servo, .torque_nm = 0, .supply_v = 0, .encoder_ticks = 0.5};
    const std::vector<double> position = traceOf(bench, 1, model, &rounding)[kPositionSignal];
    for (std::size_t row = kFirst; row < mean.size(); ++row) apart[row] += (position[row] - mean[row]) / kServos;
  }
  // Half a period of 1 ms at 0.9 rad/s is 0.45 mrad.
  const double sum = std::accumulate(apart.begin() + kFirst, apart.begin() + 2 * kFirst, 0.0);
  EXPECT_NEAR(sum / kFirst, 0, 3e-5);
}

TEST(WrittenAt, IsNeverBeforeTheReadOfTheRowBefore) {
  Trajectory log;
  log.time_s = {1, 1.005, 1.03};
  EXPECT_DOUBLE_EQ(writtenAt(log, 0, 0.01), 0);
  EXPECT_DOUBLE_EQ(writtenAt(log, 1, 0.01), 0) << "a row that came early";
  EXPECT_NEAR(writtenAt(log, 2, 0.01), 0.02, 1e-12) << "a host that paused, paused before it wrote";
  EXPECT_NEAR(writtenAt(log, 2, std::numeric_limits<double>::infinity()), 0.005, 1e-12);
}

TEST(StateAt, RowsThatAreFarApartHaveASpeed) {
  Trajectory log;
  for (int row = 0; row < 9; ++row) log.time_s.push_back(0.06 * row), log.position_rad.push_back(0.3 * 0.06 * row);
  for (const std::size_t row : {0U, 4U, 8U}) EXPECT_NEAR(stateAt(log, row).speed_rad_s, 0.3, 0.01) << row;
}

// The runtime writes all goals, and reads each servo a few periods of the firmware later.
TEST(RollOut, AGoalActsBetweenItsWriteAndTheReadOfItsRow) {
  Case bench = smallBench();
  Trajectory& log = bench.logs[0];
  log.position_rad.assign(log.rows(), 0);
  const auto first_row = [&] { return firstRowBeyond(traceOf(bench, 0, baselineOf(bench))[kLoadSignal], 0.1); };
  const std::size_t one_row_late = first_row();
  log.written_s.assign(log.rows(), 0.001);
  log.read_s.assign(log.rows(), 0.003);
  EXPECT_EQ(first_row() + 1, one_row_late);
  log.read_s = log.written_s;
  EXPECT_EQ(first_row(), one_row_late) << "no period between the two";
  // A firmware of its own is read at any phase: half a period has a period's end in it, or has not.
  log.is_phase_known = false;
  for (std::size_t row = 0; row < log.rows(); ++row) log.read_s[row] = log.written_s[row] + 0.0005;
  int soon = 0;
  constexpr int kRepeats = 40;
  for (std::uint64_t seed = 1; seed <= kRepeats; ++seed) {
    const Disturbance repeat{.seed = seed, .torque_nm = 0, .supply_v = 0, .encoder_ticks = 0};
    if (firstRowBeyond(traceOf(bench, 0, baselineOf(bench), &repeat)[kLoadSignal], 0.1) < one_row_late) ++soon;
  }
  EXPECT_GT(soon, kRepeats / 4);
  EXPECT_LT(soon, 3 * kRepeats / 4);
}

// Friction holds an arm anywhere near its goal: the log says where, the model whether it can.
TEST(RollOut, ALogBeginsWhereTheJointWasMeasured) {
  constexpr double kAside = 0.02;  // rad; 0.15 N m at this gain
  Case bench = smallBench();
  Trajectory& log = bench.logs[0];
  log.position_rad.assign(log.rows(), log.goal_rad[0] + kAside);
  const Hypothesis free = baselineOf(bench), held = withEffect(bench, "coulomb", "friction", 0.25);
  const Trace at_rest = traceOf(bench, 0, held);
  EXPECT_NEAR(at_rest[kPositionSignal][0], log.goal_rad[0] + kAside, 1e-6);
  EXPECT_LT(at_rest[kLoadSignal][0], -0.01) << "the servo pulls towards its goal";
  EXPECT_NEAR(traceOf(bench, 0, free)[kPositionSignal][0], log.goal_rad[0], 1e-3);
  // The reading may be wrong by a step of the encoder, and each repeat by another one.
  const Disturbance one{.seed = 1, .torque_nm = 0, .supply_v = 0, .encoder_ticks = 0},
      other{.seed = 2, .torque_nm = 0, .supply_v = 0, .encoder_ticks = 0};
  const auto start = [&](const Disturbance& noise) { return traceOf(bench, 0, held, &noise)[kLoadSignal][0]; };
  EXPECT_NE(start(one), start(other));
  log.position_rad[0] += 0.001;  // by chance
  EXPECT_NEAR(traceOf(bench, 0, held)[kPositionSignal][0], log.goal_rad[0] + kAside, 1e-4);
  log.position_rad.assign(log.rows(), std::nan(""));
  EXPECT_NEAR(traceOf(bench, 0, held)[kPositionSignal][0], log.goal_rad[0], 1e-3) << "commands alone";
}

// A profile has arrived at the goal long before the log begins: the arm does not sink and rise again.
TEST(RollOut, AProfileBeginsAtTheGoal) {
  Case bench = smallBench();
  Trajectory& log = bench.logs[2];  // held up at 1.2 rad
  log.position_rad.assign(log.rows(), log.goal_rad[0] - 0.03);
  Hypothesis slow = withEffect(bench, "coulomb", "friction", 0.02);
  const double soon = traceOf(bench, 2, slow)[kPositionSignal][0];
  valueOf(slow.with(*twin::findEffect("transport_delay")), "delay") = 0.08;
  EXPECT_NEAR(traceOf(bench, 2, slow)[kPositionSignal][0], soon, 1e-3);
}

TEST(RollOut, AMaskedPositionLiesBetweenItsNeighbours) {
  Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  Trajectory& log = bench.logs[2];
  log.position_rad[40] = log.position_rad[41] = log.position_rad[0] = std::nan("");
  const double from = log.position_rad[39], to = log.position_rad[42];
  EXPECT_NEAR(knownPosition(log, 40), from + (to - from) / 3, 1e-9);
  EXPECT_EQ(knownPosition(log, 0), log.position_rad[1]);
  EXPECT_NEAR(stateAt(log, 40).position_rad, knownPosition(log, 40), 0.02);
  // Neither rows nor windows that end there count, all others do.
  const Hypothesis model = baselineOf(bench);
  EXPECT_GT(rmsPositionError(plantOf(bench), bench, model, LogRole::kFit), 0);
  for (const Trajectory& one : bench.logs)
    for (const Block block : plantOf(bench).blocks()) {
      const BlockResiduals residuals = plantOf(bench).blockResiduals(block, {}, bench, one, model, {});
      for (Eigen::Index i = 0; i < residuals.residual.size(); ++i)
        ASSERT_LT(std::isnan(residuals.residual[i]) ? 0 : std::abs(residuals.residual[i]), 0.2);
    }
}

TEST(RollOut, EachLogHasItsOwnBench) {
  Case bench = smallBench();
  const double longer_m = 1.5 * bench.pendulum.length_m, heavier_kg = 0.2;
  Case other = bench;
  other.pendulum.length_m = longer_m;
  other.pendulum.arm_mass_kg = heavier_kg;
  other.model.servo.supply_v = 10;
  Trajectory& own = bench.logs[2];
  const Trace of_case = traceOf(bench, 2, baselineOf(bench));
  own.length_m = longer_m;
  own.arm_mass_kg = heavier_kg;
  own.supply_v = 10;
  const Trace trace = traceOf(bench, 2, baselineOf(bench));
  const std::vector<double> expected = traceOf(other, 2, baselineOf(other))[kPositionSignal];
  ASSERT_EQ(trace[kPositionSignal].size(), expected.size());
  for (std::size_t row = 0; row < expected.size(); ++row) {
    ASSERT_NEAR(trace[kPositionSignal][row], expected[row], 1e-9);
    ASSERT_NEAR(trace[kSupplySignal][row], 10, 1e-9);
  }
  EXPECT_NE(trace[kPositionSignal], of_case[kPositionSignal]);
  // A length that a fit changes scales every arm, and stays when the model becomes that of the case.
  Hypothesis longer = baselineOf(bench);
  longer.pendulum.length_m *= 1.1;
  EXPECT_NEAR(armOf(bench, own, longer).length_m, 1.1 * longer_m, 1e-12);
  const Case with = withModel(bench, longer);
  EXPECT_NEAR(armOf(with, with.logs[2], baselineOf(with)).length_m, 1.1 * longer_m, 1e-12);
  EXPECT_EQ(armOf(bench, bench.logs[0], baselineOf(bench)).length_m, bench.pendulum.length_m);
}

TEST(RollOut, ALimpServoShowsNoLoadAndTheArmFalls) {
  const Case bench = smallBench();
  const Trace trace = traceOf(bench, 2, baselineOf(bench));
  const std::size_t off = 33;  // rows after 0.5 s
  EXPECT_GT(trace[kLoadSignal][off - 5], 0.05) << "held against gravity";
  for (std::size_t row = off + 1; row < trace[kLoadSignal].size(); ++row) ASSERT_EQ(trace[kLoadSignal][row], 0) << row;
  EXPECT_NEAR(trace[kPositionSignal][off - 5], 1.2, 0.1);
  EXPECT_LT(*std::min_element(trace[kPositionSignal].begin(), trace[kPositionSignal].end()), -0.3)
      << "it swings through";
}

TEST(RollOut, WithDisturbanceItIsInTicksAndDiffersFromSeedToSeed) {
  const Case bench = smallBench();
  const Disturbance one{.seed = 1}, two{.seed = 2};
  const Trace a = traceOf(bench, 1, baselineOf(bench), &one), again = traceOf(bench, 1, baselineOf(bench), &one),
              b = traceOf(bench, 1, baselineOf(bench), &two);
  EXPECT_EQ(a[kPositionSignal], again[kPositionSignal]);
  EXPECT_NE(a[kPositionSignal], b[kPositionSignal]);
  for (const double position : a[kPositionSignal]) {
    const double ticks = position / kRadPerTick;
    ASSERT_NEAR(ticks, std::round(ticks), 1e-6);
  }
  double worst = 0;
  for (std::size_t row = 0; row < a[kPositionSignal].size(); ++row)
    worst = std::max(worst, std::abs(a[kPositionSignal][row] - b[kPositionSignal][row]));
  EXPECT_LT(worst, 8 * kRadPerTick) << "a bench repeats itself";
}

TEST(RollOut, TheLogsTemperatureIsTheServos) {
  Case bench = smallBench();
  Hypothesis warm = withEffect(bench, "temp_drift", "rate", 0.05);
  const Trace cold = traceOf(bench, 2, warm);
  bench.logs[2].temp_c.assign(bench.logs[2].rows(), 45);
  const Trace hot = traceOf(bench, 2, warm);
  const auto lowest = [](const Trace& t) {
    return *std::min_element(t[kPositionSignal].begin(), t[kPositionSignal].end());
  };
  EXPECT_LT(lowest(hot), lowest(cold) - 0.02) << "thin grease brakes less";
}

TEST(RollOut, ATemperatureThatIsReadNowAndThenCountsInEveryRow) {
  Case bench = smallBench();
  const Hypothesis warm = withEffect(bench, "temp_drift", "rate", 0.05);
  const std::vector<double> cold = traceOf(bench, 2, warm)[kPositionSignal];
  bench.logs[2].temp_c.assign(bench.logs[2].rows(), 45);
  const std::vector<double> always = traceOf(bench, 2, warm)[kPositionSignal];
  for (std::size_t row = 0; row < bench.logs[2].rows(); ++row)
    if (row % 20 != 3) bench.logs[2].temp_c[row] = std::nan("");
  smoothTemperatures(bench);
  const std::vector<double> sparse = traceOf(bench, 2, warm)[kPositionSignal];
  const auto apart = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::sqrt(std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus{},
                                        [](double x, double y) { return (x - y) * (x - y); }));
  };
  EXPECT_LT(apart(sparse, always), 0.01 * apart(cold, always));
}

TEST(Hypothesis, KeepsEffectsInTheOrderInWhichTheyAct) {
  const Case bench = smallBench();
  Hypothesis model = baselineOf(bench);
  model.with(*twin::findEffect("temp_drift"));
  model.with(*twin::findEffect("coulomb"));
  std::vector<const twin::EffectInfo*> wanted;
  for (const auto* effect : twin::catalogue())
    if (model.find(effect->id) != nullptr) wanted.push_back(effect);
  ASSERT_EQ(model.effects.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(model.effects[i].info, wanted[i]);
  model.without("coulomb");
  EXPECT_EQ(model.find("coulomb"), nullptr);
  EXPECT_THROW(valueOf(*model.find("viscous"), "friction"), std::logic_error);
}

TEST(ForEach, DoesEachOnceAndPassesOnWhatFails) {
  std::vector<std::atomic<int>> done(100);
  forEach(done.size(), [&](std::size_t i) { ++done[i]; });
  for (const auto& count : done) EXPECT_EQ(count, 1);
  EXPECT_THROW(forEach(10,
                       [](std::size_t i) {
                         if (i == 7) throw std::runtime_error("seven");
                       }),
               std::runtime_error);
  forEach(2, [](std::size_t) { forEach(2, [](std::size_t) {}); });  // within itself: does not hang
}

TEST(BenchPlant, TracesHaveAColumnForEachSignalAndAValueForEachRow) {
  const Case bench = smallBench();
  const Plant& plant = plantOf(bench);
  Trace trace;
  plant.rollOut(bench, 1, baselineOf(bench), {}, trace);
  ASSERT_EQ(trace.columns.size(), plant.signals().size());
  for (const auto& column : trace.columns) EXPECT_EQ(column.size(), bench.logs[1].rows());
  EXPECT_EQ(plant.signals()[kPositionSignal].kind, Signal::Kind::kPosition);
  EXPECT_EQ(plant.signals()[kSupplySignal].kind, Signal::Kind::kSupply);
}

TEST(BenchPlant, HasResidualsOfEveryBlockThatIsMeasured) {
  const Case bench = measured(smallBench(), baselineOf(smallBench()), 1);
  const Plant& plant = plantOf(bench);
  const auto known = [&](Block block) {
    const auto found =
        plant.blockResiduals(block, plant.places().front(), bench, bench.logs[1], baselineOf(bench), {}).residual;
    return found.array().isNaN().count() < found.size();
  };
  EXPECT_TRUE(known(Block::kController));
  EXPECT_TRUE(known(Block::kPlant));
  EXPECT_FALSE(known(Block::kSupply)) << "the logs have no voltage";
  EXPECT_FALSE(known(Block::kSensor)) << "the logs have no speed";
}

TEST(Hypothesis, HasAnEffectOnceAPlace) {
  const twin::EffectInfo& friction = *twin::findEffect("coulomb");
  const Place ankle{Place::Kind::kJoint, "AnkleR"}, knee{Place::Kind::kJoint, "KneeR"};
  Hypothesis robot;
  for (const Place& place : {ankle, knee, ankle}) robot.with(friction, place).values[0] += 0.1;
  ASSERT_EQ(robot.effects.size(), 2u);
  EXPECT_EQ(robot.find("coulomb", ankle)->values[0], 0.2);
  EXPECT_EQ(robot.find("coulomb", knee)->values[0], 0.1);
  EXPECT_EQ(robot.find("coulomb"), nullptr);

  const auto unknowns = unknownsOf(friction, false, knee);
  EXPECT_EQ(unknowns[0].name, "KneeR.coulomb.friction");
  const double x = unknowns[0].toSearch(0.05);
  robot = applied(robot, unknowns, &x);
  EXPECT_NEAR(robot.find("coulomb", knee)->values[0], 0.05, 1e-12);
  robot.without("coulomb", ankle);
  EXPECT_EQ(robot.effects.size(), 1u);
}

}  // namespace
}  // namespace darwinop::gap
