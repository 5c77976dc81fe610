// Controller of the viewed robot: runs `darwinop run` as a child process.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/process/child_process.hpp"

namespace darwinop::twin {

class ControllerProcess {
 public:
  /// `controller`: program or folder, and arguments. `port`: serial port of the robot. Throws std::runtime_error.
  ControllerProcess(const std::vector<std::string>& controller, const std::string& port);
  /// Sends SIGTERM, and SIGKILL after 2 s.
  ~ControllerProcess();
  ControllerProcess(const ControllerProcess&) = delete;
  ControllerProcess& operator=(const ControllerProcess&) = delete;

  /// Exit status as in a shell; empty while it runs.
  std::optional<int> ended();
  /// After SIGINT the controller moves the robot to its start pose before it ends.
  void signal(int number) { process_.signal(number); }

 private:
  process::ChildProcess process_;
};

}  // namespace darwinop::twin
