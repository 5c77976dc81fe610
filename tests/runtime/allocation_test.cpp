// The loop allocates nothing: commands in, cycle, sensors out, figures, recording, wake-up.
#include <gtest/gtest.h>

#include <memory>

#include "fake_bus.hpp"
#include "runtime/lockstep_driver.hpp"
#include "runtime/loop_host.hpp"
#include "scripted_clock.hpp"
#include "support/allocation_probe.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

TEST(Loop, AllocatesNothingInTenThousandCycles) {
  const TemporaryFolder folder;
  LoopConfig config;
  config.record_path = folder / "log.csv";
  const Exchange exchange = Exchange::inMemory();
  ScriptedClock clock;
  LoopHost host{config, std::make_unique<FakeBus>(), exchange, LoopStats::Timed::kYes, Recorder::Writer::kByHand};
  LockstepDriver driver{host.loop(), clock, config.period};
  Commands commands;
  commands.session = 1;
  const long before = allocationsOfThisThread();
  for (int i = 0; i < 10'000; ++i) {
    ++commands.sequence;
    commands.joint[18].setGoal(Rad{1e-4 * i});
    exchange.commands().commands.publish(commands);
    driver.run(1);
    clock.spend(std::chrono::milliseconds{i % 20});
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
  StatsView stats;
  exchange.block().stats.copyTo(stats);
  EXPECT_EQ(stats.cycles, 10'000u);
}

TEST(Loop, TheProbeOfThisTestCounts) {
  const long before = allocationsOfThisThread();
  const auto something = std::make_unique<int>(1);
  EXPECT_EQ(allocationsOfThisThread(), before + 1);
}

}  // namespace
}  // namespace darwinop::runtime
