// A log run again on a model.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/conversions.hpp"
#include "gap/parallel/parallel.hpp"
#include "small_case.hpp"

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
  const std::size_t after = firstRowBeyond(traceOf(bench, 0, baselineOf(bench)).load, 0.1);
  bench.goal_order = GoalOrder::kBeforeRead;
  const std::size_t before = firstRowBeyond(traceOf(bench, 0, baselineOf(bench)).load, 0.1);
  EXPECT_EQ(after, before + 1);
}

TEST(RollOut, ALimpServoShowsNoLoadAndTheArmFalls) {
  const Case bench = smallBench();
  const Trace trace = traceOf(bench, 2, baselineOf(bench));
  const std::size_t off = 33;  // rows after 0.5 s
  EXPECT_GT(trace.load[off - 5], 0.05) << "held against gravity";
  for (std::size_t row = off + 1; row < trace.load.size(); ++row) ASSERT_EQ(trace.load[row], 0) << row;
  EXPECT_NEAR(trace.position_rad[off - 5], 1.2, 0.1);
  EXPECT_LT(*std::min_element(trace.position_rad.begin(), trace.position_rad.end()), -0.3) << "it swings through";
}

TEST(RollOut, WithDisturbanceItTellsTicksAndDiffersFromSeedToSeed) {
  const Case bench = smallBench();
  const Disturbance one{.seed = 1}, two{.seed = 2};
  const Trace a = traceOf(bench, 1, baselineOf(bench), &one), again = traceOf(bench, 1, baselineOf(bench), &one),
              b = traceOf(bench, 1, baselineOf(bench), &two);
  EXPECT_EQ(a.position_rad, again.position_rad);
  EXPECT_NE(a.position_rad, b.position_rad);
  for (const double position : a.position_rad) {
    const double ticks = position / kRadPerTick;
    ASSERT_NEAR(ticks, std::round(ticks), 1e-6);
  }
  double worst = 0;
  for (std::size_t row = 0; row < a.position_rad.size(); ++row)
    worst = std::max(worst, std::abs(a.position_rad[row] - b.position_rad[row]));
  EXPECT_LT(worst, 8 * kRadPerTick) << "a bench repeats itself";
}

TEST(RollOut, TheLogsTemperatureIsTheServos) {
  Case bench = smallBench();
  Hypothesis warm = withEffect(bench, "temp_drift", "rate", 0.05);
  const Trace cold = traceOf(bench, 2, warm);
  bench.logs[2].temp_c.assign(bench.logs[2].rows(), 45);
  const Trace hot = traceOf(bench, 2, warm);
  const auto lowest = [](const Trace& t) { return *std::min_element(t.position_rad.begin(), t.position_rad.end()); };
  EXPECT_LT(lowest(hot), lowest(cold) - 0.02) << "thin grease brakes less";
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

}  // namespace
}  // namespace darwinop::gap
