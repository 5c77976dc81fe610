#include "virtual_robot_camera.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>

#include "hil-mocks/camera/frame_painter.hpp"
#include "hil-mocks/camera/test_pattern.hpp"

namespace darwinop::app {
namespace {

using Frames = std::chrono::duration<std::int64_t, std::ratio<1, 30>>;

class Painting {
 public:
  Painting(hil::PtyHost& host, const std::string& file) : host_{host}, painter_{file} {}

  void paint() {
    if (const hil::PictureSize wanted = painter_.wanted(); !(wanted == size_)) {
      size_ = wanted;
      eyes_.reset();
      // Not while the robot waits: this copies a whole model. It reads of it only what no step changes.
      Body& body = *host_.withRobot([](hil::VirtualRobot& robot) { return &robot.body(); });
      eyes_ = body.openEyes(size_.width, size_.height);
      pattern_ = hil::Picture{size_.width, size_.height};
    }
    if (eyes_ == nullptr) {
      hil::drawBall(pattern_, std::chrono::duration<double>(host_.now()).count());
      return painter_.paint(size_, pattern_.bgra);
    }
    // The robot waits for the look, not for the drawing.
    host_.withRobot([&](hil::VirtualRobot&) { eyes_->look(); });
    painter_.paint(size_, eyes_->newest().bgra);
  }

 private:
  hil::PtyHost& host_;
  hil::FramePainter painter_;
  hil::PictureSize size_{0, 0};
  std::unique_ptr<Eyes> eyes_;
  hil::Picture pattern_{2, 2};
};

void paintUntil(const std::stop_token& stop, hil::PtyHost& host, const std::unique_ptr<Painting>& painting) {
  try {
    while (!stop.stop_requested()) {
      painting->paint();
      std::this_thread::sleep_for(std::chrono::ceil<Frames>(host.now()) - host.now());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop-virtual-robot: its camera is blind from here on: %s\n", error.what());
  }
}

}  // namespace

RobotCamera::RobotCamera(hil::PtyHost& host, const std::string& file) {
  // The file is there when this returns.
  painter_ = std::jthread{[&host, painting = std::make_unique<Painting>(host, file)](const std::stop_token& stop) {
    paintUntil(stop, host, painting);
  }};
}

}  // namespace darwinop::app
