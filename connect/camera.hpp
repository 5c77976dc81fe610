// Opens the camera of any kind of robot.
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
  PictureForm form = PictureForm::kBgra;  // simulated robots support no other
  /// Receives messages about errors and recoveries; may be called from another thread.
  std::function<void(const std::string&)> log = {};
  /// Files of a daemon whose observers also get the pictures, while they request them; empty: no observers.
  std::optional<runtime::RuntimeFiles> observers = {};
};

/// The camera of this computer: robot.ini, else /dev/video0. Errors as openCamera().
std::unique_ptr<FrameSource> openLocalCamera(const CameraRequest& request);

/// The twin's head camera in lockstep, a remote robot's camera over TCP, else openLocalCamera(). The link must outlive
/// it. A disconnected camera is not an error: it is opened when it appears, and `log` reports that. Throws
/// std::runtime_error if the robot has no camera or robot.ini is invalid. Observers of a daemon get the same pictures.
std::unique_ptr<FrameSource> openCamera(runtime::RobotLink& robot, const CameraRequest& request);

}  // namespace darwinop::connect
