// What the robot's head camera sees in the twin.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hal/body.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/render/picture.hpp"
#include "twin/render/pose.hpp"

namespace darwinop::twin {

class RobotBody;
class Offscreen;

/// Takes a picture when it has looked and `period` has gone by on the body's clock, so that a lockstep run sees the
/// same pictures every time. Graphics are opened for the first one, which takes a moment. Where nothing can be drawn it
/// gives a test pattern that says why, and says so once on standard error.
class HeadCamera final : public Eyes {
 public:
  struct Options {
    int width = 320, height = 240;
    Nanos period{33'333'333};  // 30 pictures a second, as the robot's camera
  };

  /// Throws std::runtime_error for a size out of range.
  HeadCamera(RobotBody& body, const Options& options);
  explicit HeadCamera(RobotBody& body) : HeadCamera{body, Options{}} {}
  ~HeadCamera() override;

  void look() noexcept override;
  CameraFrame newest() override;
  /// A test pattern is not seen: its red bar is no ball.
  [[nodiscard]] CameraHealth health() const override { return {.seeing = blindness_.empty(), .frames = pictures_}; }

  /// The same picture as newest() gave, RGB.
  [[nodiscard]] const Picture& picture() const noexcept { return picture_; }
  [[nodiscard]] const char* blindness() const noexcept override {
    return blindness_.empty() ? nullptr : blindness_.c_str();
  }

 private:
  void draw();
  void openGraphics();

  RobotBody& body_;
  Options options_;
  MjModelPtr model_;                      // a copy of the body's, until graphics are open
  std::unique_ptr<Offscreen> offscreen_;  // null: not open yet, or blind
  std::string blindness_;
  Picture picture_;
  std::vector<std::uint8_t> bgra_;
  Pose pose_;
  bool looked_ = false;  // and not drawn what was seen
  std::uint64_t sequence_ = 0, pictures_ = 0;
  Nanos taken_{0};
};

}  // namespace darwinop::twin
