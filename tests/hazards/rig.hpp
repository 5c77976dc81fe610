// The whole chain from controller image to servo registers, in memory: what a hazard's reaction is measured on.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "core/commands.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {

/// Judged by the registers of the virtual servos and by the body, never by what the safety layer says of itself.
struct HazardRig {
  static constexpr Nanos kPeriod{16'000'000};
  static constexpr long kLimit = 2000;  // cycles, 32 s: longer than any reaction

  explicit HazardRig(const hil::BoardOptions& options = {}) : robot{options} {
    commands.session = 1;
    commands.start_where_it_is = true;
  }

  void cycle() {
    release += kPeriod;
    line.advanceTo(release);
    if (controller_steps) ++commands.sequence;
    loop.run(commands, {.release = release});
  }
  void run(long cycles) {
    for (long i = 0; i < cycles; ++i) cycle();
  }
  /// Cycles until `done` holds, at most kLimit; kLimit + 1 and a failure when it never does.
  long cyclesUntil(const std::function<bool()>& done) {
    for (long i = 0; i <= kLimit; ++i) {
      if (done()) return i;
      cycle();
    }
    ADD_FAILURE() << "no reaction within " << kLimit << " cycles";
    return kLimit + 1;
  }
  /// A controller drives every joint.
  void drive() {
    cyclesUntil([this] { return state() == State::kDriven && torqueCount() == kJoints; });
    run(60);  // past the gentle phase
  }
  void fault(hil::FaultKind kind, double amount = 0) {
    hil::InjectedFault fault;
    fault.kind = kind;
    fault.at = line.now();
    fault.amount = amount;
    fault.joints.set();
    robot.faults().add(fault);
  }

  [[nodiscard]] const Sensors& seen() const { return loop.sensors(); }
  [[nodiscard]] State state() const { return seen().safety.state; }
  [[nodiscard]] bool active(Fault fault) const { return seen().safety.active[safety::rowIndex(fault)]; }
  [[nodiscard]] const hil::ControlTable& registers(Joint joint) const { return robot.board().servo(joint).table(); }
  /// The servo has supply and holds its joint.
  [[nodiscard]] bool torque(Joint joint) const {
    return robot.board().servo(joint).listens(robot.now()) && registers(joint).byte(servo::kTorqueEnable) != 0;
  }
  [[nodiscard]] int goal(Joint joint) const { return registers(joint).word(servo::kGoalPosition); }
  [[nodiscard]] std::size_t torqueCount() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kJoints; ++i) count += torque(static_cast<Joint>(i)) ? 1 : 0;
    return count;
  }

  hil::VirtualRobot robot;
  hil::MemoryLine line{robot};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(kPeriod)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle loop{bus, guard, kPeriod};
  Commands commands{};
  bool controller_steps = true;
  Nanos release{0};
};

/// For docs/hazards.md, which is made from these figures.
inline void recordCycles(long cycles) {
  ::testing::Test::RecordProperty("cycles", std::to_string(cycles));
}

}  // namespace darwinop
