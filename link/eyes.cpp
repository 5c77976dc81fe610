#include "link/eyes.hpp"

#include <stdexcept>

#include "link/robot_file.hpp"

namespace darwinop::link {

std::unique_ptr<FrameSource> openCamera(const EyesRequest& request) {
  v4l2::CameraOptions options;
  if (const RobotFile file = readRobotFile(); file.camera) options.device = *file.camera;
  options.width = request.width;
  options.height = request.height;
  options.settings = request.settings;
  options.form = request.form;
  options.say = request.say;
  return std::make_unique<v4l2::Camera>(std::move(options));
}

std::unique_ptr<FrameSource> openEyes(runtime::RobotLink& robot, const EyesRequest& request) {
  if (auto its_own = robot.openEyes(request.width, request.height)) return its_own;
  // A camera of this computer shows another world than the simulated one.
  if (!robot.realTime()) throw std::runtime_error("this virtual robot has no camera: the twin has one, --robot twin");
  return openCamera(request);
}

}  // namespace darwinop::link
