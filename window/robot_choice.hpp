// The robot that a window is for, as --robot and --monitor name it: one of its own, the one of a runtime here, or one
// elsewhere.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/names.hpp"
#include "runtime/robot_link.hpp"
#include "window/own_robot.hpp"
#include "window/sight.hpp"

namespace darwinop::window {

struct RobotChoice {
  std::string robot = "twin";
  std::string monitor{};       // HOST[:PORT]; empty: beside the robot's server
  std::string logged_in_to{};  // USER@HOST; empty: nowhere
};

/// Told of trouble, from other threads, too.
using SayLine = std::function<void(const std::string&)>;

/// Nothing: the robot of a runtime that runs here or elsewhere. Throws std::runtime_error.
std::unique_ptr<OwnRobot> ownRobot(const RobotChoice& choice, const std::vector<std::string>& controller);

/// `files`: of the runtime here. `painted`: what the own robot sees; empty: it is not the window's own.
Sight sightOf(const RobotChoice& choice, const runtime::RuntimeFiles& files, const std::string& painted,
              const std::shared_ptr<monitor::ColourSearch>& search, const SayLine& say);

/// Throws std::runtime_error where the window only looks on.
std::unique_ptr<runtime::RobotLink> linkToDrive(const RobotChoice& choice, const runtime::RuntimeFiles& files,
                                                const SayLine& say);

}  // namespace darwinop::window
