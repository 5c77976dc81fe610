// Environment of a program that uses a virtual camera.
#pragma once

#include <string>
#include <vector>

namespace darwinop::hil {

/// NAME=VALUE each, for a camera at `device` with pictures from `file`. Throws std::runtime_error if the shim library
/// is not beside the running program.
std::vector<std::string> cameraSettings(const std::string& file, const std::string& device);

}  // namespace darwinop::hil
