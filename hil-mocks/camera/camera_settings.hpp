// What a program has to be started with to see a virtual camera.
#pragma once

#include <string>
#include <vector>

namespace darwinop::hil {

/// NAME=VALUE each, for a camera at `device` whose pictures are painted into `file`. Throws std::runtime_error when the
/// camera's library is not where it belongs: beside the running program.
std::vector<std::string> cameraSettings(const std::string& file, const std::string& device);

}  // namespace darwinop::hil
