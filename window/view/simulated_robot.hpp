// The window's own virtual robot: processes of virtual robot, runtime and optionally a controller.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "window/child.hpp"
#include "window/private_folder.hpp"

namespace darwinop::window {

class SimulatedRobot {
 public:
  /// `body`: "twin", "twin:MODEL" or "plain". `controller`: program and arguments; empty: none. Throws
  /// std::runtime_error.
  SimulatedRobot(const std::string& body, const std::vector<std::string>& controller);
  /// Ends controller, runtime and robot, in this order.
  ~SimulatedRobot() { end(); }
  SimulatedRobot(const SimulatedRobot&) = delete;
  SimulatedRobot& operator=(const SimulatedRobot&) = delete;

  /// Name of the runtime, for `darwinop runtime --name` and DARWINOP_RUNTIME_NAME.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Its serial port, a pty, which its runtime uses.
  [[nodiscard]] std::string port() const { return folder_.path() + "/robot"; }
  /// File of rendered camera pictures, written while they are read.
  [[nodiscard]] std::string cameraFile() const { return folder_.path() + "/camera"; }
  /// Instructions for the user: how to start a controller on it from another terminal.
  [[nodiscard]] std::string driveInstructions() const;
  /// Message for the user if a process has ended since the last call; otherwise empty.
  std::string takeMessage();

 private:
  void start(const std::string& body, const std::vector<std::string>& controller);
  void end() noexcept;

  PrivateFolder folder_;
  std::string name_;
  std::vector<std::string> camera_settings_;  // environment that gives a controller camera pictures
  std::string pending_message_;
  std::vector<std::unique_ptr<Child>> children_;  // ended in reverse order
};

}  // namespace darwinop::window
