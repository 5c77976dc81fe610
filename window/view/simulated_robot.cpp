// Processes of the window's own virtual robot.
#include "window/view/simulated_robot.hpp"

#include <unistd.h>

#include <stdexcept>
#include <thread>
#include <utility>

#include "connect/robot_file.hpp"
#include "hil-mocks/camera/camera_settings.hpp"
#include "runtime/names.hpp"

namespace darwinop::window {
namespace {

// The runtime's time suffices for the virtual robot to sit down.
constexpr std::chrono::seconds kRobotGrace{1}, kRuntimeGrace{6}, kControllerGrace{2};
constexpr std::chrono::seconds kStart{20};

/// Waits until `child` has created this file. Throws std::runtime_error if it does not.
void waitForFile(const std::string& path, Child& child) {
  const auto end = std::chrono::steady_clock::now() + kStart;
  while (access(path.c_str(), F_OK) != 0) {
    if (child.ended())
      throw std::runtime_error("darwinop " + child.noun() + " has ended before it was ready; see its output above");
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error("darwinop " + child.noun() +
                               " was not ready within 20 s; reduce the load of this computer and try again");
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
}

}  // namespace

SimulatedRobot::SimulatedRobot(const std::string& body, const std::vector<std::string>& controller)
    : name_{folder_.path() + "/runtime"} {
  try {
    start(body, controller);
  } catch (...) {
    end();
    throw;
  }
}

void SimulatedRobot::start(const std::string& body, const std::vector<std::string>& controller) {
  const auto add = [this](const std::string& noun, const std::vector<std::string>& words, std::chrono::seconds grace,
                          Child::Stdio stdio = Child::Stdio::kBackground,
                          const std::vector<std::string>& environment = {}) -> Child& {
    return *children_.emplace_back(std::make_unique<Child>(noun, words, grace, stdio, environment));
  };
  waitForFile(port(), add("virtual-robot", {"--link", port(), "--body", body, "--camera", cameraFile()}, kRobotGrace));
  waitForFile(runtime::RuntimeFiles{name_}.exchange,
              add("runtime", {"--robot", port(), "--wait", "--name", name_}, kRuntimeGrace));
  try {
    camera_settings_ = hil::cameraSettings(cameraFile(), connect::readRobotFile().camera.value_or("/dev/video0"));
  } catch (const std::runtime_error& error) {  // the page has pictures nevertheless
    pending_message_ = std::string{"A controller on this virtual robot has no camera: "} + error.what() + ".";
  }
  if (controller.empty()) return;
  std::vector<std::string> environment = camera_settings_;
  environment.push_back("DARWINOP_RUNTIME_NAME=" + name_);  // the controller finds the runtime by this name
  std::vector<std::string> words{"--robot", "runtime", "--"};
  words.insert(words.end(), controller.begin(), controller.end());
  add("run", words, kControllerGrace, Child::Stdio::kTerminal, environment);
}

void SimulatedRobot::end() noexcept {
  while (!children_.empty()) children_.pop_back();
}

std::string SimulatedRobot::driveInstructions() const {
  std::string text = "drive it: darwinop run CONTROLLER --robot runtime, with DARWINOP_RUNTIME_NAME=" + name_;
  if (!camera_settings_.empty()) text += "\nfor camera pictures, also with";
  for (const std::string& setting : camera_settings_) text += ' ' + setting;
  return text;
}

std::string SimulatedRobot::takeMessage() {
  std::string text = std::exchange(pending_message_, "");
  for (auto child = children_.begin(); child != children_.end();) {
    const std::optional<int> status = (*child)->ended();
    if (!status) {
      ++child;
      continue;
    }
    if (!text.empty()) text += ' ';
    text += "darwinop " + (*child)->noun() + " has ended (status " + std::to_string(*status) + ").";
    child = children_.erase(child);
  }
  return text;
}

}  // namespace darwinop::window
