// The same property with the real bus on the virtual board, judged at the torque enable registers of its servos.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>

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

/// What lives in one process.
struct Process {
  Process(hil::MemoryLine& line, const Config& config)
      : bus{line, cm730::BusConfig::forPeriod(kPeriod)}, guard{config}, loop{bus, guard, kPeriod} {}
  cm730::Cm730Bus bus;
  Guard guard;
  runtime::Cycle loop;
};

struct Loop {
  explicit Loop(const Config& config = {}, const hil::BoardOptions& servos = slowServos()) : robot{servos} {
    start(config);
  }

  hil::VirtualRobot robot;
  hil::MemoryLine line{robot};
  std::unique_ptr<Process> process;
  Commands commands;
  Nanos release{0};
  int powered = 0;  // times that servo power came on
  bool had_power = false;

  /// The process before, if there was one, is dead.
  void start(const Config& config) {
    process = std::make_unique<Process>(line, config);
    commands = {};
  }
  void cycle() {
    release += kPeriod;
    line.advanceTo(release);
    if (commands.session != 0) ++commands.sequence;
    process->loop.run(commands, {.release = release});
    const bool power = process->loop.sensors().board.servo_power;
    if (power && !had_power) ++powered;
    had_power = power;
  }
  void run(Nanos time) {
    for (const Nanos end = release + time; release < end;) cycle();
  }
  void press(std::uint8_t button, Nanos time) { fault(hil::FaultKind::kButton, time, button); }
  void reset() { fault(hil::FaultKind::kReset, 0ms); }
  void fault(hil::FaultKind kind, Nanos lasts, std::uint8_t bits = 0) {
    hil::InjectedFault fault;
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
  [[nodiscard]] State state() const { return process->loop.sensors().safety.state; }
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

/// Who presses RESET when a controller crashes does not look first whether torque is off already.
TEST(ReleaseOnTheBoard, AResetJustAfterAControllersEndIsAReleaseIfAServoStillHeld) {
  Config config;
  config.on_exit = OnExit::kLimp;
  int held = 0;
  for (int phase = 0; phase < 8; ++phase) {
    Loop loop{config};
    loop.drive();
    loop.commands.end_of_session = true;
    for (int i = 0; i < phase / 2; ++i) loop.cycle();
    loop.line.advanceTo(loop.release + phase % 2 * kPeriod / 2);
    if (!loop.anyTorque()) continue;
    ++held;
    loop.reset();
    loop.run(100ms);
    EXPECT_EQ(loop.cyclesWithTorque(2s), 0) << phase;
  }
  EXPECT_GT(held, 0);
}

/// Torque off is a broadcast that nobody acknowledges: here one servo does not receive it.
TEST(ReleaseOnTheBoard, AResetBeforeALostTorqueOffWasSeenIsARelease) {
  Config config;
  config.on_exit = OnExit::kLimp;
  hil::BoardOptions servos = slowServos();
  servos.servo[index(Joint::kLegLowerR)].keeps_torque = true;
  for (int cycles = 0; cycles < 24; cycles += 3) {
    Loop loop{config, servos};
    loop.drive();
    loop.commands.end_of_session = true;
    for (int i = 0; i < cycles; ++i) loop.cycle();
    ASSERT_TRUE(loop.anyTorque()) << cycles;
    loop.reset();
    loop.run(200ms);
    EXPECT_EQ(loop.cyclesWithTorque(2s), 0) << cycles;
  }
}

TEST(ReleaseOnTheBoard, AResetOfARobotThatWasFoundStiffIsAReleaseAlsoWhileTheBoardIsSilent) {
  Loop loop;
  loop.drive();
  loop.start(Config{});  // nobody drives; the servos hold
  loop.run(2s);
  ASSERT_EQ(loop.state(), State::kFoundStiff);
  loop.fault(hil::FaultKind::kUnplug, 500ms);
  loop.run(300ms);
  ASSERT_EQ(loop.state(), State::kOffline);
  loop.reset();
  loop.run(500ms);
  EXPECT_EQ(loop.cyclesWithTorque(5s), 0);
}

TEST(ReleaseOnTheBoard, AResetBeforeOrAfterTheDeathOfALoopThatHeldTheRobotIsARelease) {
  // After the third cycle it has latched the fault itself, and its note of that outlives it (runtime/robot_notes.hpp).
  for (int lived_on = 0; lived_on < 3; ++lived_on) {
    Loop loop;
    loop.drive();
    loop.reset();
    for (int i = 0; i < lived_on; ++i) loop.cycle();
    Config after_death;
    after_death.held_before = true;
    loop.start(after_death);
    loop.run(100ms);
    EXPECT_EQ(loop.cyclesWithTorque(5s), 0) << lived_on;
    EXPECT_EQ(loop.state(), State::kLimp);
    loop.press(kStart, 400ms);
    loop.run(500ms);
    loop.session(true);
    loop.run(2s);
    EXPECT_TRUE(loop.anyTorque()) << "a person has acted";
  }
}

TEST(ReleaseOnTheBoard, ALoopThatBeginsOnABoardJustSwitchedOnDrives) {
  Loop loop;
  loop.session(true);
  loop.run(3s);
  EXPECT_EQ(loop.state(), State::kDriven);
}

/// A limp robot loses its power again and again, no fault is latched, and a controller is started again by itself.
TEST(ReleaseOnTheBoard, StartBringsBackPowerThatIsWithheldAlsoUnderASession) {
  Loop loop;
  loop.run(1s);
  for (int i = 0; i < 4; ++i) {
    loop.reset();
    loop.run(1s);
  }
  ASSERT_FALSE(loop.had_power);
  loop.session(true);
  loop.run(2s);
  ASSERT_FALSE(loop.anyTorque());
  loop.press(kStart, 400ms);
  loop.run(3s);
  EXPECT_EQ(loop.state(), State::kDriven);
  EXPECT_TRUE(loop.anyTorque());
}

}  // namespace
}  // namespace darwinop::safety
