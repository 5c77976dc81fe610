// Command started by darwinop-virtual-camera, with the environment for the camera.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace darwinop::app {

/// Prepends `environment`; no signal is blocked, and kIgnoredSignals have their defaults. Returns -1 on failure,
/// already reported.
pid_t startWith(std::vector<std::string> environment, const std::vector<std::string>& command);

}  // namespace darwinop::app
