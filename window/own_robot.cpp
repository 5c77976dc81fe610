#include "window/own_robot.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>
#include <utility>

#include "connect/robot_file.hpp"
#include "hil-mocks/camera/camera_settings.hpp"
#include "runtime/names.hpp"
#include "window/scoped_settings.hpp"

namespace darwinop::window {
namespace {

// A virtual robot cannot be hurt; a runtime that is given this long sits it down.
constexpr std::chrono::seconds kRobotGrace{1}, kRuntimeGrace{6}, kControllerGrace{2};
constexpr std::chrono::seconds kStart{20};

/// `child` is about to make this file. Throws std::runtime_error when it does not.
void waitForFile(const std::string& path, Child& child) {
  const auto end = std::chrono::steady_clock::now() + kStart;
  while (access(path.c_str(), F_OK) != 0) {
    if (child.ended())
      throw std::runtime_error("darwinop " + child.noun() +
                               " has ended before it was ready; what it said stands above");
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error("darwinop " + child.noun() + " was not ready within 20 s; is this computer very busy?");
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
}

}  // namespace

OwnRobot::OwnRobot(const std::string& body, const std::vector<std::string>& controller)
    : name_{folder_.path() + "/runtime"} {
  try {
    start(body, controller);
  } catch (...) {
    end();
    throw;
  }
}

void OwnRobot::start(const std::string& body, const std::vector<std::string>& controller) {
  const std::string port = folder_.path() + "/robot";
  const auto add = [this](const std::string& noun, const std::vector<std::string>& words, std::chrono::seconds grace,
                          Child::Place place = Child::Place::kBehind) -> Child& {
    return *children_.emplace_back(std::make_unique<Child>(noun, words, grace, place));
  };
  waitForFile(port, add("virtual-robot", {"--link", port, "--body", body, "--camera", eyes()}, kRobotGrace));
  waitForFile(runtime::RuntimeFiles{name_}.exchange,
              add("runtime", {"--robot", port, "--wait", "--name", name_}, kRuntimeGrace));
  try {
    eye_settings_ = hil::cameraSettings(eyes(), connect::readRobotFile().camera.value_or("/dev/video0"));
  } catch (const std::runtime_error& error) {  // the page sees all the same
    untold_ = std::string{"A controller on this virtual robot has no camera: "} + error.what() + ". ";
  }
  if (controller.empty()) return;
  setenv("DARWINOP_RUNTIME_NAME", name_.c_str(), 1);  // where it looks for the runtime
  const ScopedSettings sees{eye_settings_};
  std::vector<std::string> words{"--robot", "runtime", "--"};
  words.insert(words.end(), controller.begin(), controller.end());
  add("run", words, kControllerGrace, Child::Place::kTerminal);
}

void OwnRobot::end() noexcept {
  while (!children_.empty()) children_.pop_back();
}

std::string OwnRobot::howToDrive() const {
  std::string text = "drive it: darwinop run CONTROLLER --robot runtime, with DARWINOP_RUNTIME_NAME=" + name_;
  if (!eye_settings_.empty()) text += "\nso that it sees, also with";
  for (const std::string& setting : eye_settings_) text += ' ' + setting;
  return text;
}

std::string OwnRobot::news() {
  std::string text = std::exchange(untold_, "");
  for (auto child = children_.begin(); child != children_.end();) {
    const std::optional<int> status = (*child)->ended();
    if (!status) {
      ++child;
      continue;
    }
    text += "darwinop " + (*child)->noun() + " has ended (status " + std::to_string(*status) + "). ";
    child = children_.erase(child);
  }
  return text;
}

}  // namespace darwinop::window
