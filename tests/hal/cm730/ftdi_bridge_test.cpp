// A loop of 8 ms behind an FTDI bridge, in simulated time: whether its cycles fit, and what the start-up check says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "hal/cm730/bus.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/probe.hpp"
#include "hil-mocks/latency_timer.hpp"
#include "hil-mocks/memory_line.hpp"
#include "support/safe_commands_for_tests.hpp"

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;

/// The bridge: a request leaves with the next USB frame, replies wait for a full packet or the latency timer, and
/// reach the PC with the next USB frame.
class BridgedLine final : public ByteLine {
 public:
  BridgedLine(hil::MemoryLine& line, Nanos latency, Nanos usb_frame)
      : line_{line}, timer_{latency}, usb_frame_{usb_frame} {}

  [[nodiscard]] Nanos now() noexcept override { return now_; }
  void advanceTo(Nanos when) { now_ = std::max(now_, when); }

  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override {
    sendPending(now_);
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
    leaves_ = nextFrame(now_);
    return LineStatus::kOk;
  }

  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    count = 0;
    while (true) {
      if (!ready_.empty() && arrives_ <= std::max(now_, deadline)) {
        now_ = std::max(now_, arrives_);
        count = std::min(into.size(), ready_.size());
        std::copy_n(ready_.begin(), count, into.begin());
        ready_.erase(ready_.begin(), ready_.begin() + static_cast<std::ptrdiff_t>(count));
        return LineStatus::kOk;
      }
      if (!pump(deadline)) {
        now_ = std::max(now_, deadline);
        return LineStatus::kTimeout;
      }
    }
  }

  void discardInput() noexcept override {
    std::size_t count = 0;
    std::array<std::uint8_t, 512> rubbish{};
    while (read(rubbish, count, now_) == LineStatus::kOk) {
    }
  }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return 0; }

 private:
  [[nodiscard]] Nanos nextFrame(Nanos when) const {
    return usb_frame_ == 0ns ? when : ((when + usb_frame_ - 1ns) / usb_frame_) * usb_frame_;
  }
  void sendPending(Nanos until) {
    if (pending_.empty() || leaves_ > until) return;
    line_.advanceTo(leaves_);
    line_.write(pending_);
    pending_.clear();
  }
  /// Lets the next thing happen that happens until then; false: nothing does.
  bool pump(Nanos deadline) {
    sendPending(deadline);
    std::array<std::uint8_t, 512> bytes{};
    std::size_t count = 0;
    const Nanos until = std::min(deadline, timer_.due());
    const auto deliver = [&](Bytes packet) {
      ready_.insert(ready_.end(), packet.begin(), packet.end());
      arrives_ = nextFrame(line_.now());
    };
    if (line_.now() <= until && line_.read(bytes, count, until) == LineStatus::kOk) {
      timer_.take(Bytes{bytes}.first(count), line_.now(), deliver);
      return true;
    }
    if (timer_.due() > deadline) return false;
    line_.advanceTo(timer_.due());
    timer_.expire(line_.now(), deliver);
    return true;
  }

  hil::MemoryLine& line_;
  hil::LatencyTimer timer_;
  Nanos usb_frame_, now_{0}, leaves_{0}, arrives_{0};
  std::vector<std::uint8_t> pending_, ready_;
};

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
