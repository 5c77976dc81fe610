// Loop figures: what is counted, and differences over a run.
#include "runtime/loop_stats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace darwinop::runtime {
namespace {

Sensors cycleWith(std::int64_t wake_us, std::int64_t bus_us, std::uint32_t overruns) {
  Sensors s;
  s.wake_latency_ns = wake_us * 1000;
  s.slack_ns = 9'000'000;
  s.wire.bus_ns = bus_us * 1000;
  s.wire.wire_ns = 5'000'000;
  s.overruns = overruns;
  s.link.retries = 2 * overruns;
  return s;
}

TEST(LoopStats, CountsEveryCycle) {
  const auto stats = std::make_unique<LoopStats>();
  for (int i = 0; i < 99; ++i) stats->account(cycleWith(30, 5200, 0), 0, LoopStats::Timed::kYes);
  stats->account(cycleWith(400, 30'000, 1), 3, LoopStats::Timed::kYes);
  StatsView view;
  stats->copyTo(view);
  EXPECT_EQ(view.cycles, 100u);
  EXPECT_EQ(view.overruns, 1u);
  EXPECT_EQ(view.skipped, 3u);
  EXPECT_EQ(view.retries, 2u);
  EXPECT_EQ(view.wake.percentile(0.5), 30);
  EXPECT_EQ(view.wake.max(), 400);
  EXPECT_NEAR(view.bus.percentile(0.5), 5200, 16);
  EXPECT_NEAR(view.bus.max(), 30'000, 1);
  EXPECT_EQ(view.slack.total(), 99u) << "the first cycle has none before it";
}

TEST(LoopStats, DoesNotTakeSimulatedTimeForAMeasurement) {
  const auto stats = std::make_unique<LoopStats>();
  stats->account(cycleWith(0, 5000, 0), 0, LoopStats::Timed::kNo);
  StatsView view;
  stats->copyTo(view);
  EXPECT_TRUE(std::isnan(view.wake.percentile(0.5)));
  EXPECT_TRUE(std::isnan(view.bus.percentile(0.5)));
  EXPECT_NEAR(view.wire.percentile(0.5), 5000, 16) << "wire time is computed, not measured";
}

TEST(LoopStats, ADifferenceCoversOneRunOnly) {
  const auto stats = std::make_unique<LoopStats>();
  for (int i = 0; i < 50; ++i) stats->account(cycleWith(900, 9000, 5), 5, LoopStats::Timed::kYes);
  StatsView before, after;
  stats->copyTo(before);
  for (int i = 0; i < 10; ++i) stats->account(cycleWith(20, 5000, 6), 6, LoopStats::Timed::kYes);
  stats->copyTo(after);
  const StatsView run = after.since(before);
  EXPECT_EQ(run.cycles, 10u);
  EXPECT_EQ(run.overruns, 1u);
  EXPECT_EQ(run.retries, 2u);
  EXPECT_EQ(run.wake.max(), 20);
}

}  // namespace
}  // namespace darwinop::runtime
