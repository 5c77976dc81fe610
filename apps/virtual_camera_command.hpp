// The program that darwinop-virtual-camera starts, and what it needs to see the camera.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace darwinop::app {

/// Started with `environment` in front of ours, no signal blocked, and those of kIgnoredSignals with their defaults.
/// -1: it cannot be, and why is told.
pid_t startWith(std::vector<std::string> environment, const std::vector<std::string>& command);

}  // namespace darwinop::app
