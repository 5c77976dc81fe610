#include "window/own_robot.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace darwinop::window {
namespace {

// A virtual robot cannot be hurt; a runtime that is given this long sits it down.
constexpr std::chrono::seconds kRobotGrace{1}, kRuntimeGrace{6}, kControllerGrace{2};

std::string privateFolder() {
  std::string path = (std::filesystem::temp_directory_path() / "darwinop-window-XXXXXX").string();
  if (mkdtemp(path.data()) == nullptr)
    throw std::runtime_error("cannot make a folder " + path + ": " + std::strerror(errno));
  return path;
}

}  // namespace

OwnRobot::OwnRobot(const std::string& body, const std::vector<std::string>& controller)
    : folder_{privateFolder()}, name_{"darwinop-window-" + std::to_string(getpid())} {
  const std::string port = folder_ + "/robot";
  children_.push_back(
      std::make_unique<Child>("virtual-robot", std::vector<std::string>{"--link", port, "--body", body}, kRobotGrace));
  children_.push_back(std::make_unique<Child>(
      "runtime", std::vector<std::string>{"--robot", port, "--wait", "--name", name_}, kRuntimeGrace));
  if (controller.empty()) return;
  // Where it looks for the runtime.
  setenv("DARWINOP_RUNTIME_NAME", name_.c_str(), 1);
  std::vector<std::string> words{"--robot", "runtime", "--"};
  words.insert(words.end(), controller.begin(), controller.end());
  children_.push_back(std::make_unique<Child>("run", words, kControllerGrace));
}

OwnRobot::~OwnRobot() {
  while (!children_.empty()) children_.pop_back();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string OwnRobot::news() {
  std::string text;
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
