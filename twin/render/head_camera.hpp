// Simulated head camera of the twin.
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

/// look() stores the pose once per `period` of the body's clock, so that a lockstep run is repeatable; newest() renders
/// it. OpenGL is initialized for the first picture. Without OpenGL it returns a test pattern with the reason and logs
/// the reason once.
class HeadCamera final : public BodyCamera {
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
  /// `seeing` is false for a test pattern, so that its red bar is not detected as a ball.
  [[nodiscard]] CameraHealth health() const override { return {.seeing = render_error_.empty(), .frames = pictures_}; }

  /// The picture that newest() returned, as RGB.
  [[nodiscard]] const RenderedPicture& picture() const noexcept { return picture_; }
  [[nodiscard]] const char* renderError() const noexcept override {
    return render_error_.empty() ? nullptr : render_error_.c_str();
  }

 private:
  void draw();
  void openGraphics();

  RobotBody& body_;
  Options options_;
  MjModelPtr model_;                      // copy of the body's model, until OpenGL is initialized
  std::unique_ptr<Offscreen> offscreen_;  // null: not initialized yet, or OpenGL is not available
  std::string render_error_;
  RenderedPicture picture_;
  std::vector<std::uint8_t> bgra_;
  Pose pose_;
  bool looked_ = false;  // pose_ is not rendered yet
  std::uint64_t sequence_ = 0, pictures_ = 0;
  Nanos taken_{0};
};

}  // namespace darwinop::twin
