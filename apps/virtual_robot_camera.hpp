// What the virtual robot sees, painted for a virtual camera: programs that open /dev/video0 see it.
#pragma once

#include <string>
#include <thread>

#include "hil-mocks/pty_host.hpp"

namespace darwinop::app {

/// Paints into a file, up to 30 times a second while somebody looks, in a thread of its own and of low priority, for
/// programs started with the settings that cameraSettings() names. A body without eyes shows a ball on a circle.
class RobotCamera {
 public:
  /// Throws std::runtime_error.
  RobotCamera(hil::PtyHost& host, const std::string& file);

 private:
  std::jthread painter_;
};

}  // namespace darwinop::app
