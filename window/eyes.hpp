// What the window's program shows of a robot that is on this computer.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "monitor/monitor.hpp"

namespace darwinop::window {

/// `painted`: the file into which the window's own robot paints what it sees, whoever drives it; then no camera of this
/// computer is touched. Empty: the robot's own camera. `search` is shown each frame. `say` is told of trouble, from
/// other threads, too.
std::unique_ptr<monitor::Monitor> monitorWithEyes(const runtime::RuntimeFiles& files, const std::string& painted,
                                                  const std::shared_ptr<monitor::ColourSearch>& search,
                                                  const std::function<void(const std::string&)>& say);

}  // namespace darwinop::window
