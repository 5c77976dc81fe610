// The whole loop against the virtual robot in simulated time: guard, bus, board, servos, body.
#pragma once

#include <memory>
#include <utility>

#include "core/commands.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {

/// Passes bytes on; while `loses_answers` all answers are lost.
class LossyLine final : public ByteLine {
 public:
  explicit LossyLine(ByteLine& inner) : inner_{inner} {}
  bool loses_answers = false;

  [[nodiscard]] Nanos now() noexcept override { return inner_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override { return inner_.write(bytes); }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    LineStatus status = inner_.read(into, count, deadline);
    while (loses_answers && status == LineStatus::kOk) status = inner_.read(into, count, deadline);
    if (loses_answers) count = 0;
    return status;
  }
  void discardInput() noexcept override { inner_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return inner_.reconnects(); }

 private:
  ByteLine& inner_;
};

/// Servos need a while to start, and protections look every millisecond, as in a real one.
inline hil::BoardOptions bootsIn(Nanos boot) {
  hil::BoardOptions options;
  options.servo_boot = boot;
  options.body_step = std::chrono::milliseconds{1};
  return options;
}

struct WireRig {
  explicit WireRig(std::unique_ptr<Body> body = nullptr, const hil::BoardOptions& options = {},
                   const safety::Config& safety = {})
      : robot{options, 1, std::move(body)}, config{safety} {
    commands.session = 1;
    commands.start_where_it_is = true;
  }

  void cycle() {
    release += kPeriod;
    memory.advanceTo(release);
    ++commands.sequence;
    loop.run(commands, {.release = release, .wake_latency = std::exchange(late, Nanos{0})});
  }
  /// No cycle runs for so long. A loop that waits for a release wakes late; one that overruns skips releases.
  void stall(Nanos lasts, bool wakes_late) {
    memory.advanceTo(release + lasts);
    if (wakes_late)
      late = lasts - kPeriod;
    else
      release += lasts - kPeriod;
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) cycle();
  }
  /// Supply of some servos is gone from `at` on, for so long.
  void cutSupply(const std::bitset<kJoints>& joints, Nanos at, Nanos lasts) {
    hil::InjectedFault fault;
    fault.kind = hil::FaultKind::kDead;
    fault.at = at;
    fault.lasts = lasts;
    fault.joints = joints;
    robot.faults().add(fault);
  }
  [[nodiscard]] const Sensors& seen() const { return loop.sensors(); }
  [[nodiscard]] State state() const { return seen().safety.state; }
  [[nodiscard]] bool allDriven() const {
    return std::ranges::all_of(seen().joint, [](const JointSensors& j) { return j.driven; });
  }

  static cm730::BusConfig busConfig(const hil::BoardOptions& options) {
    cm730::BusConfig config = cm730::BusConfig::forPeriod(kPeriod);
    config.board = options.board;
    return config;
  }

  static constexpr Nanos kPeriod{16'000'000};
  hil::VirtualRobot robot;
  hil::MemoryLine memory{robot};
  LossyLine line{memory};
  cm730::Cm730Bus bus{line, busConfig(robot.board().options())};
  safety::Config config;
  safety::Guard guard{config};
  runtime::Cycle loop{bus, guard, kPeriod};
  Commands commands{};
  Nanos release{0}, late{0};
};

}  // namespace darwinop
