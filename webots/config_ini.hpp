// config.ini: what a controller says about itself and about the robot's limits.
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
  std::vector<std::string> warnings;  // sentences; the controller goes on
};

/// Reads the text of a file called `file`. Throws std::runtime_error that names file, line, key and what is
/// allowed when a value is wrong.
ConfigReading parseConfig(std::string_view text, const std::string& file);

/// True for the sizes that the robot's camera offers.
bool cameraHasSize(int width, int height);

/// Reads `path`; a file that is not there gives the defaults and a warning, one that cannot be read throws.
ConfigReading readConfig(const std::string& path);

}  // namespace darwinop::webots_api
