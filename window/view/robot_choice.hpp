// Selection of the robot by --robot and --monitor: the window's own virtual robot, a local runtime, or a remote robot.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/names.hpp"
#include "runtime/robot_link.hpp"
#include "window/live/cycle_source.hpp"
#include "window/view/monitor_feed.hpp"
#include "window/view/simulated_robot.hpp"

namespace darwinop::window {

struct RobotChoice {
  std::string robot = "twin";
  std::string monitor{};       // HOST[:PORT]; empty: on the host of the robot's server
  std::string logged_in_to{};  // USER@HOST of an ssh login; empty: none
};

/// The robot is on another computer.
[[nodiscard]] bool isRemote(const RobotChoice& choice);

/// The local runtime is selected, and none runs.
[[nodiscard]] bool hasNoRuntimeYet(const RobotChoice& choice, const runtime::RuntimeFiles& files);

/// Receives errors, also from other threads.
using LogLine = std::function<void(const std::string&)>;

/// Starts the window's own virtual robot; null: another robot is selected. Throws std::runtime_error, before anything
/// starts if the arguments are wrong.
std::unique_ptr<SimulatedRobot> startSimulatedRobot(const RobotChoice& choice,
                                                    const std::vector<std::string>& controller);

/// `files`: of the local runtime. `rendered`: camera file of the own virtual robot; empty: another robot.
MonitorFeed openMonitorFeed(const RobotChoice& choice, const runtime::RuntimeFiles& files, const std::string& rendered,
                            const std::shared_ptr<monitor::ColourSearch>& search, const LogLine& log);

/// Opens the source of the live comparison, without waiting: names are resolved here. Throws std::runtime_error.
std::function<std::unique_ptr<CycleSource>()> cycleSourceOf(const RobotChoice& choice,
                                                            const runtime::RuntimeFiles& files);

/// Throws std::runtime_error if the window only observes.
std::unique_ptr<runtime::RobotLink> openDriveLink(const RobotChoice& choice, const runtime::RuntimeFiles& files,
                                                  const LogLine& log);

}  // namespace darwinop::window
