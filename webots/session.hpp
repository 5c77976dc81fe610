// A controller's time with a robot: publish, wait, read one consistent image, know when to end.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hal/camera_v4l2/camera.hpp"
#include "runtime/driver_session.hpp"
#include "webots/time_line.hpp"

namespace darwinop::webots_api {

/// Used by one thread.
class Session {
 public:
  /// `stop` becomes true when the user asks the controller to end.
  Session(std::unique_ptr<runtime::RobotLink> link, const std::atomic<bool>& stop);

  /// Offers `first` until the robot stands ready and obeys. Empty: it does; else a sentence that says why not.
  [[nodiscard]] std::string begin(const Commands& first);

  /// Offers the image to the loop and sets the end of the step, `ms` after the end of the one before.
  void publish(const Commands& commands, int ms);
  /// Waits for that end and takes the newest image. 0 in time, positive: ms late, -1: the controller must end.
  [[nodiscard]] int wait();

  [[nodiscard]] const Sensors& sensors() const { return sensors_; }
  /// Since the robot stood ready. After a step in time it is that of the newest image, so that steps add up exactly;
  /// it goes on from there, except in lockstep.
  [[nodiscard]] Nanos time() const;
  [[nodiscard]] Nanos period() const { return driver_.link().period(); }
  [[nodiscard]] bool realTime() const { return driver_.link().realTime(); }
  /// What this robot sees; it must not outlive the session. Throws std::runtime_error if it has no camera.
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height, const v4l2::CameraSettings& settings);

 private:
  [[nodiscard]] bool waitForTarget();
  int end(const std::string& sentence);

  runtime::DriverSession driver_;
  const std::atomic<bool>& stop_;
  Commands asked_{};
  Sensors sensors_{};
  TimeLine line_;
  std::uint64_t target_ = 0;    // cycle that this step ends with
  Nanos returned_{0}, due_{0};  // when the last step ended; when this one should
  Nanos origin_{0};             // release of the cycle that found the robot ready
  Nanos reached_{0};            // time() when the last step ended
  bool ended_ = false;
};

}  // namespace darwinop::webots_api
