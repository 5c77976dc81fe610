// Test installation in a temporary folder with a virtual robot, and external inspection of that robot.
#pragma once

#include <sys/types.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "hal/cm730/diagnosis/transactions.hpp"
#include "hal/cm730/serial_port.hpp"
#include "runtime/exchange.hpp"
#include "runtime/file_lock.hpp"
#include "supervisor/status.hpp"
#include "system/rig.hpp"

namespace darwinop::supervisor {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Registers of the robot while the port is free.
struct Registers {
  int panel = -1, head = -1;  // LEDs; -1: no answer
  int stiff = 0, silent = 0;  // servos
  double furthest = 0;        // rad, leg joint from its start pose
};

class Home : public Rig {
 protected:
  void SetUp() override {
    Rig::SetUp();
    std::filesystem::create_directories(folder_ / "home/controllers/walk");
    std::filesystem::create_symlink(controller(), folder_ / "home/controllers/walk/walk");
    std::ofstream{folder_ / "home/robot.ini"} << "[Robot]\nport = " << port()
                                              << "\ncontroller_user = root\n[Safety]\ngentle_speed = 2.0\n";
  }
  void TearDown() override {
    if (supervisor_ && supervisor_->pid() > 0) {
      supervisor_->kill(SIGTERM);
      supervisor_->wait(seconds{20});
    }
    if (HasFailure() && supervisor_) std::cout << supervisor_->output() << controllerLog();
    supervisor_.reset();
    Rig::TearDown();
  }

  /// Behaviour of the default controller from its next start on.
  void plan(const std::string& what) {
    std::ofstream{folder_ / "home/controllers/walk/plan"} << what << '\n';
    const auto link = folder_ / "home/default";
    if (!std::filesystem::is_symlink(link)) std::filesystem::create_symlink("controllers/walk", link);
  }
  void startSupervisor() {
    supervisor_ = std::make_unique<Program>(
        std::vector<std::string>{program("darwinop-supervisor"), "--home", file("home")}, file("supervisor.txt"));
  }
  /// Returns the exit code; output is in `said_`.
  int ask(const std::string& option) {
    Program asking{{program("darwinop-supervisor"), option}, file("ask.txt")};
    const auto code = asking.wait(seconds{40});
    said_ = asking.output();
    return code.value_or(-1);
  }

  [[nodiscard]] Status status() const {
    return readStatus(SupervisorFiles{runtime::RuntimeFiles{}}.status).value_or(Status{});
  }
  /// As if the last supervisor could not have recorded how it ended.
  static void forgetRecord() { std::filesystem::remove(SupervisorFiles{runtime::RuntimeFiles{}}.status); }
  [[nodiscard]] std::string controllerLog() const {
    std::ostringstream text;
    text << std::ifstream{folder_ / "home/log/controller.log"}.rdbuf();
    return text.str();
  }
  template <class Condition>
  static bool within(seconds time, Condition condition) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(milliseconds{5});
    }
    return true;
  }
  [[nodiscard]] bool says(const std::string& text, seconds time = seconds{15}) const {
    return supervisor_->says(text, time);
  }
  [[nodiscard]] bool controllerSays(const std::string& text, seconds time = seconds{15}) const {
    return within(time, [&] { return controllerLog().find(text) != std::string::npos; });
  }

  /// Newest image of the present loop; cycle 0: none.
  [[nodiscard]] static Sensors sensors() {
    Sensors seen;
    try {
      (void)runtime::Exchange::attach(runtime::RuntimeFiles{}.exchange, runtime::Exchange::Access::kRead)
          .block()
          .sensors.read(seen);
    } catch (const std::runtime_error&) {
      return {};
    }
    return seen;
  }

  /// For a second: a busy computer may miss some cycles before the scripted fault.
  static bool staysOffline() {
    auto since = std::chrono::steady_clock::now();
    return within(seconds{30}, [&since] {
      const auto now = std::chrono::steady_clock::now();
      if (sensors().safety.state != State::kOffline) since = now;
      return now - since > seconds{1};
    });
  }

  /// Reads board and servos. The port must be free.
  [[nodiscard]] Registers registers() const {
    cm730::SerialPort line{port()};
    Registers found;
    const auto board = cm730::readRegisters(line, kBoardId, find(kCm730, "led_panel").address, 3);
    if (board.ok()) {
      found.panel = board.data()[0];
      found.head = board.data()[1] + 256 * board.data()[2];
    }
    for (const JointRow& joint : kJointTable) {
      const auto servo = cm730::readRegisters(line, joint.id, servo::kTorqueEnable, 14);
      found.silent += servo.ok() ? 0 : 1;
      if (!servo.ok()) continue;
      found.stiff += servo.data()[0] != 0 ? 1 : 0;
      const int ticks = servo.data()[12] + 256 * servo.data()[13];
      if (joint.id >= 7 && joint.id <= 18)
        found.furthest = std::max(found.furthest, std::abs(ticks - joint.start) * kRadPerTick);
    }
    return found;
  }

  /// Stretches the legs and leaves them under torque, as after a computer restart. The port must be free.
  void standByHand() const {
    cm730::SerialPort line{port()};
    const std::array<std::uint8_t, 1> on{1};
    ASSERT_TRUE(cm730::writeRegisters(line, kBoardId, board::kDxlPower, on).ok());
    cm730::pass(line, Nanos{500'000'000});
    constexpr std::array<std::uint8_t, 2> kStraight{0x00, 0x08};  // 2048 ticks
    for (std::uint8_t id = 7; id <= 18; ++id)
      ASSERT_TRUE(cm730::writeRegisters(line, id, servo::kGoalPosition, kStraight).ok());
    cm730::pass(line, Nanos{2'000'000'000});
  }

  /// As RESET does: all servos lose power for a moment. The port must be free.
  void pressReset() const {
    cm730::SerialPort line{port()};
    const std::array<std::uint8_t, 1> off{0};
    ASSERT_TRUE(cm730::writeRegisters(line, kBoardId, board::kDxlPower, off).ok());
    cm730::pass(line, Nanos{200'000'000});
  }

  std::unique_ptr<Program> supervisor_;
  std::string said_;
};

}  // namespace darwinop::supervisor
