// config.ini: settings of a controller, including [Safety] and [Limits].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hal/camera_v4l2/camera.hpp"
#include "safety/config.hpp"

namespace darwinop::webots_api {

struct ControllerConfig {
  int time_step_ms = 16;  // 1..10000
  int camera_width = 320, camera_height = 240;
  v4l2::CameraSettings camera{};
  safety::Config safety{};
};

struct ConfigReading {
  ControllerConfig config;
  std::vector<std::string> warnings;  // messages for the user; not fatal
};

/// Parses the text of `file`. Throws std::runtime_error with file, line, key and allowed values if a value is invalid.
ConfigReading parseConfig(std::string_view text, const std::string& file);

/// True for sizes that the robot's camera supports.
bool cameraHasSize(int width, int height);

/// Reads `path`. A missing file gives the defaults and a warning; throws std::runtime_error if it cannot be read.
ConfigReading readConfig(const std::string& path);

}  // namespace darwinop::webots_api
