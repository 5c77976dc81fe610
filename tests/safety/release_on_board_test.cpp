// The same property with the real bus on the virtual board, judged at the torque enable registers of its servos.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "core/commands.hpp"
#include "core/registers.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop::safety {
namespace {

using namespace std::chrono_literals;

constexpr Nanos kPeriod = 16ms;
constexpr std::uint8_t kMode = 1, kStart = 2;

hil::BoardOptions slowServos() {
  hil::BoardOptions options;
  options.servo_boot = 200ms;
  return options;
}

struct Loop {
  hil::VirtualRobot robot{slowServos()};
  hil::MemoryLine line{robot};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(kPeriod)};
  Guard guard{Config{}};
  runtime::Cycle loop{bus, guard, kPeriod};
  Commands commands;
  Nanos release{0};
  int powered = 0;  // times that servo power came on
  bool had_power = false;

  void cycle() {
    release += kPeriod;
    line.advanceTo(release);
    if (commands.session != 0) ++commands.sequence;
    loop.run(commands, {.release = release});
    const bool power = loop.sensors().board.servo_power;
    if (power && !had_power) ++powered;
    had_power = power;
  }
  void run(Nanos time) {
    for (const Nanos end = release + time; release < end;) cycle();
  }
  void press(std::uint8_t button, Nanos time) { fault(hil::FaultKind::kButton, time, button); }
  void reset() { fault(hil::FaultKind::kReset, 0ms); }
  void fault(hil::FaultKind kind, Nanos lasts, std::uint8_t bits = 0) {
    hil::Fault fault;
    fault.kind = kind;
    fault.at = line.now();
    fault.lasts = lasts;
    fault.bits = bits;
    robot.faults().add(fault);
  }
  void session(bool unattended) {
    const std::uint32_t next = commands.session + 1;
    commands = {};
    commands.session = next;
    commands.unattended = unattended;
    commands.start_where_it_is = true;
  }
  [[nodiscard]] bool anyTorque() const {
    return std::ranges::any_of(kJointTable, [this](const JointRow& joint) {
      return robot.board().servo(static_cast<Joint>(joint.id - 1)).table().byte(servo::kTorqueEnable) != 0;
    });
  }
  [[nodiscard]] State state() const { return loop.sensors().safety.state; }
  void drive() {
    session(false);
    for (int i = 0; i < 500 && state() != State::kDriven; ++i) cycle();
    ASSERT_EQ(state(), State::kDriven);
    ASSERT_TRUE(anyTorque());
  }
  /// Cycles with torque, while a controller moves an arm and its supervisor starts it again and again.
  int cyclesWithTorque(Nanos time) {
    int with_torque = 0;
    for (const Nanos end = release + time; release < end;) {
      if (release.count() % 1'600'000'000 == 0) session(true);
      commands.joint[index(Joint::kShoulderR)].setGoal(Rad{0.4});
      cycle();
      with_torque += anyTorque() ? 1 : 0;
    }
    return with_torque;
  }
};

TEST(ReleaseOnTheBoard, AfterModeNoServoGetsTorqueUntilStart) {
  Loop loop;
  loop.drive();
  loop.press(kMode, 400ms);
  loop.run(500ms);
  ASSERT_FALSE(loop.anyTorque());
  EXPECT_EQ(loop.cyclesWithTorque(10s), 0);
  loop.press(kStart, 400ms);
  loop.run(500ms);
  loop.session(true);
  loop.run(2s);
  EXPECT_TRUE(loop.anyTorque());
}

TEST(ReleaseOnTheBoard, AfterResetNoServoGetsTorqueUntilStart) {
  Loop loop;
  loop.drive();
  loop.reset();
  loop.run(100ms);
  ASSERT_FALSE(loop.anyTorque());
  EXPECT_EQ(loop.cyclesWithTorque(10s), 0);
  EXPECT_EQ(loop.state(), State::kLimp);
  EXPECT_TRUE(loop.had_power) << "what the servos say can be read";
  loop.press(kStart, 400ms);
  loop.run(500ms);
  loop.session(true);
  loop.run(2s);
  EXPECT_TRUE(loop.anyTorque());
}

TEST(ReleaseOnTheBoard, ThirtyResetsInARowSwitchPowerOnAgainThreeTimes) {
  Loop loop;
  loop.drive();
  loop.powered = 0;
  int with_torque = 0;
  for (int i = 0; i < 30; ++i) {
    loop.reset();
    loop.run(100ms);
    with_torque += loop.cyclesWithTorque(1s);
  }
  EXPECT_EQ(with_torque, 0);
  EXPECT_EQ(loop.powered, 3);
  EXPECT_FALSE(loop.had_power);
}

TEST(ReleaseOnTheBoard, AResetAtAnyPhaseOfATakeoverEndsLimp) {
  for (int phase = 0; phase < 30; ++phase) {
    Loop loop;
    loop.run(1s);
    loop.session(false);
    for (int i = 0; i < phase; ++i) loop.cycle();
    const bool taken = drives(loop.state());
    loop.reset();
    loop.run(100ms);
    if (!taken) continue;
    EXPECT_EQ(loop.cyclesWithTorque(2s), 0) << phase;
  }
}

}  // namespace
}  // namespace darwinop::safety
