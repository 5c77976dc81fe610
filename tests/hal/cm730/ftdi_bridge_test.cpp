// A loop of 8 ms behind an FTDI bridge, in simulated time: whether its cycles fit, and what the start-up check says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "hal/cm730/bridged_line.hpp"
#include "hal/cm730/bus.hpp"
#include "hal/cm730/diagnosis/cycle_time.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hil-mocks/memory_line.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;

struct Outcome {
  int too_long = 0;  // cycles that took longer than their period
  int incomplete = 0;
  Nanos worst{0}, worst_goals{0};
  RobotFacts facts;
};

/// `cycles` cycles of a loop that sends goals, and all settings with them in one of 16.
Outcome run(Nanos period, Nanos latency, Nanos usb_frame, int cycles) {
  hil::BoardOptions options;
  options.servo_power = true;
  hil::VirtualRobot robot{options};
  hil::MemoryLine memory{robot};
  BridgedLine line{memory, latency, usb_frame};
  ProbeOptions look = ProbeOptions::quick();
  look.period = period;
  Outcome outcome;
  outcome.facts = measure(line, look);
  Cm730Bus bus{line, BusConfig::forPeriod(period)};
  BusReadings readings{};
  const Nanos begin = line.now() + 1ms;
  for (int i = 0; i < cycles; ++i) {
    // The loop's clock and that of USB are not the same: 137 us of drift a cycle go through every phase.
    const Nanos release = begin + i * (period + 137us);
    line.advanceTo(release);
    bus.write(SafeCommandsForTests{}.driveAll(Rad{0.001 * (i % 100)}).commands);
    bus.read(readings);
    const Nanos took = line.now() - release;
    outcome.worst = std::max(outcome.worst, took);
    const bool goals_alone = readings.wire.bytes_out < 200;
    if (goals_alone) outcome.worst_goals = std::max(outcome.worst_goals, took);
    outcome.too_long += took > period ? 1 : 0;
    const bool all = std::ranges::all_of(readings.servo, &ServoReading::answered);
    outcome.incomplete += readings.board.answered && all ? 0 : 1;
  }
  return outcome;
}

class EightMilliseconds : public testing::TestWithParam<Nanos> {};
INSTANTIATE_TEST_SUITE_P(UsbFrame, EightMilliseconds, testing::Values(0ms, 1ms));

TEST_P(EightMilliseconds, WorkWithALatencyTimerOfOne) {
  constexpr int kCycles = 2'000;
  const Outcome outcome = run(8ms, 1ms, GetParam(), kCycles);
  const auto ms = [](Nanos time) { return static_cast<double>(time.count()) * 1e-6; };
  std::printf(
      "USB frames of %.0f ms: worst cycle %.2f ms with goals alone, %.2f ms with a full write; too long %d of %d\n",
      ms(GetParam()), ms(outcome.worst_goals), ms(outcome.worst), outcome.too_long, kCycles);
  EXPECT_TRUE(cycleFits(outcome.facts)) << "the start-up check must not refuse what holds";
  EXPECT_EQ(outcome.too_long, 0);
  EXPECT_EQ(outcome.incomplete, 0);
}

TEST_P(EightMilliseconds, AreRejectedWithTheDefaultLatencyTimerOfSixteen) {
  const Outcome outcome = run(8ms, 16ms, GetParam(), 100);
  EXPECT_FALSE(cycleFits(outcome.facts));
  EXPECT_GT(outcome.incomplete, 90) << "rightly refused";
}

TEST_P(EightMilliseconds, SixteenAreAlsoRejected) {
  const Outcome outcome = run(16ms, 16ms, GetParam(), 100);
  EXPECT_FALSE(cycleFits(outcome.facts));
  EXPECT_GT(outcome.incomplete, 90);
}

TEST_P(EightMilliseconds, TheCheckRejectsEveryBridgeThatLosesReplies) {
  for (const Nanos latency : {1ms, 2ms, 3ms, 5ms, 7ms})
    for (const Nanos period : {8ms, 10ms, 16ms, 40ms}) {
      const Outcome outcome = run(period, latency, GetParam(), 64);
      if (!cycleFits(outcome.facts)) continue;
      EXPECT_EQ(outcome.too_long + outcome.incomplete, 0) << latency / 1ms << " ms at a period of " << period / 1ms;
    }
}

}  // namespace
}  // namespace darwinop::cm730
