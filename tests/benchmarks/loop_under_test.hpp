// The whole loop on any line, driven by a controller that moves every joint a little in every cycle.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "hal/cm730/bus.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "replay.hpp"
#include "runtime/exchange.hpp"
#include "runtime/loop.hpp"
#include "safety/guard.hpp"

namespace darwinop::bench {

inline constexpr Nanos kPeriod{16'000'000};
inline constexpr std::uint64_t kWarmUp = 400;    // cycles until torque is on and every joint is driven
inline constexpr std::uint64_t kMeasured = 320;  // all of the rotations: full write every 16, poll every 20 cycles

inline hil::BoardOptions robotWith(std::size_t servos) {
  hil::BoardOptions options;
  for (std::size_t i = 0; i < kJoints; ++i) options.servo[i].missing = i >= servos;
  return options;
}

template <class Line>
class LoopUnderTest {
 public:
  LoopUnderTest(Line& line, std::size_t servos) : servos_{servos}, clock_{line}, bus_{line, {.period = kPeriod}} {}

  /// One cycle: what the controller wants, and the loop's turn.
  void cycle() noexcept {
    publish();
    turn();
  }
  void publish() noexcept {
    Commands commands;
    commands.session = 1;
    commands.sequence = ++cycles_;
    commands.start_where_it_is = true;
    const double swing = 0.02 * std::sin(static_cast<double>(cycles_) * 0.1);
    for (std::size_t i = 0; i < servos_; ++i) commands.joint[i].setGoal(Rad{radFromTicks(middle(i)).value + swing});
    exchange_.commands().commands.publish(commands);
  }
  void turn() noexcept { loop_.step(pacer_); }

  [[nodiscard]] Sensors sensors() const {
    Sensors newest;
    (void)exchange_.block().sensors.read(newest);
    return newest;
  }

 private:
  static int middle(std::size_t joint) { return (kJointTable[joint].low + kJointTable[joint].high) / 2; }

  std::size_t servos_;
  std::uint64_t cycles_ = 0;
  LineClock<Line> clock_;
  cm730::Cm730Bus bus_;
  safety::Guard guard_{safety::Config{}};
  runtime::Exchange exchange_ = runtime::Exchange::inMemory();
  runtime::Loop loop_{bus_, guard_, exchange_, nullptr, kPeriod, runtime::LoopStats::Timed::kYes};
  runtime::Pacer pacer_{clock_, kPeriod};
};

/// What a robot with so many servos says in `cycles` cycles.
inline Recording record(std::size_t servos, std::uint64_t cycles) {
  Recording recording;
  hil::VirtualRobot robot{robotWith(servos)};
  hil::MemoryLine memory{robot};
  RecordingLine line{memory, recording};
  LoopUnderTest loop{line, servos};
  while (cycles-- > 0) loop.cycle();
  return recording;
}

}  // namespace darwinop::bench
