// Camera picture of the virtual robot for a virtual camera: programs see it at /dev/video0.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "hil-mocks/pty_host.hpp"

namespace darwinop::app {

/// Paints into a file, up to 30 times per second on request, in a low-priority thread, for programs with the
/// environment of cameraSettings(). A body without camera shows a ball on a circle.
class RobotCamera {
 public:
  /// Throws std::runtime_error.
  RobotCamera(hil::PtyHost& host, const std::string& file);

 private:
  std::jthread painter_;
};

/// The camera that paints into `file`, and the environment for programs on stdout. Null: no file.
std::unique_ptr<RobotCamera> makeCamera(hil::PtyHost& host, const std::string& file);

}  // namespace darwinop::app
