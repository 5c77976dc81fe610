// The program that darwinop-virtual-camera starts, and what it needs to see the camera.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace darwinop::app {

/// NAME=VALUE each. Throws std::runtime_error when the camera's library is not where it belongs.
std::vector<std::string> cameraSettings(const std::string& file, const std::string& device);

/// Started with `environment` in front of ours and no signal blocked. -1: it cannot be, and why is told.
pid_t startWith(std::vector<std::string> environment, const std::vector<std::string>& command);

}  // namespace darwinop::app
