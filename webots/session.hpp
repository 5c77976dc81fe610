// Session of a controller: publish commands, wait for the end of a step, read one consistent image, detect the end.
#pragma once

#include <atomic>
#include <chrono>
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
  /// `stop` becomes true when the user requests the controller to end.
  Session(std::unique_ptr<runtime::RobotLink> link, const std::atomic<bool>& stop);

  /// Publishes `first` until the robot executes this session's commands. Returns an error message; empty: success.
  [[nodiscard]] std::string begin(const Commands& first);

  /// Publishes the image and sets the end of the step to `ms` after the end of the previous one.
  void publish(const Commands& commands, int ms);
  /// Waits for the end of the step and takes the newest image. Returns 0: in time; positive: ms late; -1: the
  /// controller must end.
  [[nodiscard]] int wait();
  /// One more step after wait() returned -1, or between two steps: publishes, and waits `step` whatever is requested.
  /// False: the loop has ended, or safety does not execute the commands.
  [[nodiscard]] bool carryOn(const Commands& commands, Nanos step);

  [[nodiscard]] const Sensors& sensors() const { return sensors_; }
  /// Time since begin() returned. After a step that was in time: time of the newest image, so that steps add up
  /// exactly. Between steps it advances in real time; not in lockstep.
  [[nodiscard]] Nanos time() const;
  [[nodiscard]] Nanos period() const { return driver_.link().period(); }
  /// The same in ms; and the time of the newest image, ms: it advances by whole cycles.
  [[nodiscard]] double periodMs() const { return std::chrono::duration<double, std::milli>(period()).count(); }
  [[nodiscard]] double robotMs() const { return static_cast<double>(sensors_.time_ns) * 1e-6; }
  [[nodiscard]] bool realTime() const { return driver_.link().realTime(); }
  /// The robot's camera; must not outlive the session. Throws std::runtime_error if the robot has none.
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height, const v4l2::CameraSettings& settings);

 private:
  [[nodiscard]] bool waitForTarget();
  [[nodiscard]] bool reaches(std::uint64_t cycle);
  /// True if safety executes this session's commands.
  [[nodiscard]] bool executes(const Sensors& seen) const;
  int end(const std::string& sentence);

  runtime::DriverSession driver_;
  const std::atomic<bool>& stop_;
  Commands asked_{};
  Sensors sensors_{};
  TimeLine line_;
  std::uint64_t target_ = 0;    // last cycle of this step
  Nanos returned_{0}, due_{0};  // end of the last step; scheduled end of this one
  Nanos origin_{0};             // release of the cycle in which the robot was ready
  Nanos reached_{0};            // time() at the end of the last step
  bool ended_ = false;
};

}  // namespace darwinop::webots_api
