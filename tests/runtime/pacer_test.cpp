// The grid of releases under overruns, without sleeping.
#include "runtime/pacer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

#include "scripted_clock.hpp"

namespace darwinop::runtime {
namespace {

using namespace std::chrono_literals;

struct Drive {
  ScriptedClock clock;
  Nanos start = clock.now();
  Pacer pacer{clock, 16ms};
  std::vector<CycleTime> seen;

  void cycle(Nanos busy) {
    pacer.step([&](const CycleTime& time) {
      seen.push_back(time);
      clock.spend(busy);
    });
  }
  [[nodiscard]] Nanos release(std::size_t i) const { return seen[i].release - start; }
};

TEST(Pacer, KeepsTheGridWhateverACycleTakes) {
  Drive run;
  for (const auto busy : {5ms, 1ms, 15ms, 16ms}) run.cycle(busy);
  run.cycle(1ms);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(run.release(i), (i + 1) * 16ms);
  EXPECT_EQ(run.seen[1].slack, 11ms);
  EXPECT_EQ(run.seen[4].slack, 0ms) << "ending with the release is not an overrun";
  EXPECT_EQ(run.seen[4].overruns, 0u);
  EXPECT_EQ(run.pacer.skipped(), 0u);
}

TEST(Pacer, ReportsHowLateACycleBeganAndDoesNotMoveTheGridForIt) {
  Drive run;
  run.clock.oversleep(3ms);
  run.cycle(5ms);
  run.cycle(5ms);
  EXPECT_EQ(run.seen[0].wake_latency, 3ms);
  EXPECT_EQ(run.seen[1].wake_latency, 0ms);
  EXPECT_EQ(run.seen[1].slack, 8ms);
  EXPECT_EQ(run.release(1), 32ms);
}

TEST(Pacer, AfterAnOverrunSkipsToTheNextGridPoint) {
  Drive run;
  run.cycle(17ms);
  run.cycle(1ms);
  run.cycle(1ms);
  EXPECT_EQ(run.release(1), 48ms) << "the release at 32 ms had passed";
  EXPECT_EQ(run.release(2), 64ms);
  EXPECT_EQ(run.seen[1].overruns, 1u);
  EXPECT_EQ(run.seen[1].slack, -1ms);
  EXPECT_EQ(run.pacer.skipped(), 1u);
}

TEST(Pacer, AfterALongStallRunsOneCycleAndNoBurst) {
  Drive run;
  run.cycle(5s);
  run.cycle(1ms);
  run.cycle(1ms);
  EXPECT_EQ(run.seen[2].overruns, 1u);
  EXPECT_EQ(run.pacer.skipped(), 312u) << "32 ms to 5008 ms";
  EXPECT_EQ(run.release(2) - run.release(1), 16ms);
  EXPECT_EQ(run.seen[1].wake_latency, 0ms);
}

TEST(Pacer, ReleasesAreGridPointsThatOnlyGoUpAndNoneIsUnaccounted) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint32_t>& busy_us) {
    Drive run;
    for (const std::uint32_t us : busy_us) run.cycle(std::chrono::microseconds{us % 100'000});
    for (std::size_t i = 0; i < run.seen.size(); ++i) {
      RC_ASSERT(run.release(i) % 16ms == 0ns);
      RC_ASSERT(run.seen[i].wake_latency == 0ns);
      if (i > 0) RC_ASSERT(run.release(i) > run.release(i - 1));
      if (i > 0) RC_ASSERT((run.seen[i].slack < 0ns) == (run.seen[i].overruns > run.seen[i - 1].overruns));
    }
    run.cycle(0ms);
    const auto skipped = run.release(run.seen.size() - 1) / 16ms - static_cast<std::int64_t>(run.seen.size());
    RC_ASSERT(skipped == run.pacer.skipped());
  }));
}

}  // namespace
}  // namespace darwinop::runtime
