// Monitor of a robot on this computer, with its camera.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "monitor/monitor.hpp"

namespace darwinop::window {

/// `rendered`: file of camera pictures of the window's virtual robot; no camera of this computer is opened then. Empty:
/// the robot's camera. `search` gets each frame. `log` gets errors, also from other threads.
std::unique_ptr<monitor::Monitor> makeLocalMonitor(const runtime::RuntimeFiles& files, const std::string& rendered,
                                                   const std::shared_ptr<monitor::ColourSearch>& search,
                                                   const std::function<void(const std::string&)>& log);

}  // namespace darwinop::window
