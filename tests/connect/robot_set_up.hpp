// A robot on a pty whose servos and board are set up in some way.
#pragma once

#include <string>
#include <vector>

#include "connect/serial_bus.hpp"
#include "hil-mocks/pty_host.hpp"
#include "hil-mocks/robot_options.hpp"

namespace darwinop::connect {

struct RobotSetUp {
  /// Settings of servos ("Neck=missing") and of the board ("no-bulk-read").
  explicit RobotSetUp(const std::vector<std::string>& settings) : robot{options(settings)}, host{robot} {}
  static hil::BoardOptions options(const std::vector<std::string>& settings) {
    hil::BoardOptions options;
    for (const std::string& setting : settings)
      setting.find('=') == setting.npos ? hil::setBoard(options, setting) : hil::setServo(options, setting);
    return options;
  }
  [[nodiscard]] SerialRobot serial() const {
    SerialRobot serial;
    serial.port = host.path();
    return serial;
  }
  int goalTicks(Joint joint) {
    return host.withRobot(
        [&](hil::VirtualRobot& r) { return r.board().servo(joint).table().word(servo::kGoalPosition); });
  }
  int byteOf(Joint joint, std::uint8_t address) {
    return host.withRobot([&](hil::VirtualRobot& r) { return r.board().servo(joint).table().byte(address); });
  }
  hil::VirtualRobot robot;
  hil::PtyHost host;
};

}  // namespace darwinop::connect
