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

struct CameraRequest {
  int width = 320, height = 240;
  v4l2::CameraSettings settings{};
  PictureForm form = PictureForm::kBgra;  // a simulated robot has no other
  /// Receives errors and recoveries, perhaps from another thread.
  std::function<void(const std::string&)> log = {};
  /// Of the daemon whose observers see the pictures also, while they ask for them; empty: there are none.
  std::optional<runtime::RuntimeFiles> observers = {};
};

/// The camera of this computer that robot.ini names, or /dev/video0, independent of the driver. As openCamera().
std::unique_ptr<FrameSource> openLocalCamera(const CameraRequest& request);

/// The twin's head camera in lockstep, a robot's over TCP; else the camera of this computer that robot.ini names, or
/// /dev/video0. The link has to outlive it. A camera that is not there is no error: it may come, and `log` reports it.
/// Throws std::runtime_error when the robot has no camera, or robot.ini is wrong.
/// Where the loop is a daemon's, its observers see what this camera sees.
std::unique_ptr<FrameSource> openCamera(runtime::RobotLink& robot, const CameraRequest& request);

}  // namespace darwinop::connect
