// The loop allocates nothing: commands in, cycle, sensors out, figures, recording, wake-up.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <new>

#include "fake_bus.hpp"
#include "runtime/lockstep_driver.hpp"
#include "runtime/loop_host.hpp"
#include "scripted_clock.hpp"
#include "temporary_folder.hpp"

namespace {
std::size_t allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}
// Not inlined: g++ would otherwise see free() meet new and warn.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace darwinop::runtime {
namespace {

TEST(Loop, AllocatesNothingInTenThousandCycles) {
  const TemporaryFolder folder;
  LoopConfig config;
  config.record_path = folder / "log.csv";
  const Exchange exchange = Exchange::inMemory();
  ScriptedClock clock;
  LoopHost host{config, std::make_unique<FakeBus>(), exchange.block(), LoopStats::Timed::kYes,
                Recorder::Writer::kByHand};
  LockstepDriver driver{host.loop(), clock, config.period};
  Commands commands;
  commands.session = 1;
  const std::size_t before = allocations;
  for (int i = 0; i < 10'000; ++i) {
    ++commands.sequence;
    commands.joint[18].setGoal(Rad{1e-4 * i});
    exchange.block().commands.publish(commands);
    driver.run(1);
    clock.spend(std::chrono::milliseconds{i % 20});
  }
  EXPECT_EQ(allocations, before);
  StatsView stats;
  exchange.block().stats.copyTo(stats);
  EXPECT_EQ(stats.cycles, 10'000u);
}

TEST(Loop, TheProbeOfThisTestCounts) {
  const std::size_t before = allocations;
  const auto something = std::make_unique<int>(1);
  EXPECT_EQ(allocations, before + 1);
}

}  // namespace
}  // namespace darwinop::runtime
