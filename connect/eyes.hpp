// What a robot sees, whichever kind it is.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/frame_source.hpp"
#include "runtime/names.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::connect {

struct EyesRequest {
  int width = 320, height = 240;
  v4l2::CameraSettings settings{};
  PictureForm form = PictureForm::kBgra;  // a simulated robot has no other
  /// Told what goes wrong and what comes back, perhaps from another thread.
  std::function<void(const std::string&)> say = {};
  /// Of the daemon whose onlookers see the pictures, too, while they ask for them; empty: there are none.
  std::optional<runtime::RuntimeFiles> onlookers = {};
};

/// The camera of this computer that robot.ini names, or /dev/video0, whoever drives the robot. As openEyes().
std::unique_ptr<FrameSource> openCamera(const EyesRequest& request);

/// The twin's head camera in lockstep, a robot's over TCP; else the camera of this computer that robot.ini names, or
/// /dev/video0. The link has to outlive it. A camera that is not there is no error: it may come, and `say` is told.
/// Throws std::runtime_error when the robot has no eyes, or robot.ini is wrong.
/// Where the loop is a daemon's, its onlookers see what this camera sees.
std::unique_ptr<FrameSource> openEyes(runtime::RobotLink& robot, const EyesRequest& request);

}  // namespace darwinop::connect
