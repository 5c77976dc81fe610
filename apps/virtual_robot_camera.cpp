#include "virtual_robot_camera.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "hil-mocks/camera/camera_settings.hpp"
#include "hil-mocks/camera/frame_painter.hpp"
#include "hil-mocks/camera/test_pattern.hpp"

namespace darwinop::app {
namespace {

constexpr int kNice = 10;  // of the painting thread and of threads started by its graphics library
constexpr std::chrono::milliseconds kBlindPause{50};
constexpr int kMostRate = 30;  // pictures per second
using Frames = std::chrono::duration<std::int64_t, std::ratio<1, kMostRate>>;

class Painting {
 public:
  Painting(hil::PtyHost& host, const std::string& file) : host_{host}, painter_{file} {}

  void paint() {
    if (const int rate = painter_.wantedRate(); rate == 0 || (rate < kMostRate && ++turn_ % 2 != 0)) return;
    if (const hil::PictureSize wanted = painter_.wanted(); !(wanted == size_)) {
      size_ = wanted;
      camera_.reset();
      Body* body = nullptr;
      host_.askRobot([&body](hil::VirtualRobot& robot) { body = &robot.body(); });
      // Copies a whole model without blocking the robot: reads only what steps do not modify.
      camera_ = body->openCamera(size_.width, size_.height);
      pattern_ = hil::PaintedPicture{size_.width, size_.height};
    }
    if (camera_ == nullptr) {
      hil::drawBall(pattern_, std::chrono::duration<double>(host_.now()).count());
      return painter_.paint(size_, pattern_.bgra);
    }
    // Capturing the scene runs in the robot's thread, rendering in this one, which may wait for the CPU.
    host_.askRobot([this](hil::VirtualRobot&) { camera_->look(); });
    const CameraFrame picture = camera_->newest();
    // The error picture is for people: a colour finder would take its red bar for a ball.
    const char* const why = camera_->renderError();
    if (why == nullptr) return painter_.paint(size_, picture.bgra);
    painter_.giveUp(why);
    painter_.setFault(hil::CameraFault::kSilent);
    blind_ = true;
  }

  [[nodiscard]] bool blind() const { return blind_; }

 private:
  hil::PtyHost& host_;
  hil::FramePainter painter_;
  hil::PictureSize size_{0, 0};
  std::unique_ptr<BodyCamera> camera_;
  hil::PaintedPicture pattern_{2, 2};
  unsigned turn_ = 0;
  bool blind_ = false;
};

void paintUntil(const std::stop_token& stop, hil::PtyHost& host, const std::unique_ptr<Painting>& painting) {
  try {
    // Software rendering is slow: the robot's loop has priority.
    setpriority(PRIO_PROCESS, 0, kNice);
    while (!stop.stop_requested() && !painting->blind()) {
      painting->paint();
      std::this_thread::sleep_for(std::chrono::ceil<Frames>(host.now()) - host.now());
    }
    // The file stays and contains the reason.
    while (!stop.stop_requested()) std::this_thread::sleep_for(kBlindPause);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop-virtual-robot: camera failed: %s\n", error.what());
  }
}

}  // namespace

RobotCamera::RobotCamera(hil::PtyHost& host, const std::string& file) {
  // The file exists on return.
  painter_ = std::jthread{[&host, painting = std::make_unique<Painting>(host, file)](const std::stop_token& stop) {
    paintUntil(stop, host, painting);
  }};
}

std::unique_ptr<RobotCamera> makeCamera(hil::PtyHost& host, const std::string& file) {
  if (file.empty()) return nullptr;
  const std::string path = std::filesystem::absolute(file);
  auto camera = std::make_unique<RobotCamera>(host, path);
  try {
    const std::vector<std::string> settings = hil::cameraSettings(path, "/dev/video0");
    std::printf("camera: /dev/video0, for programs started with\n");
    for (const std::string& setting : settings) std::printf("export %s\n", setting.c_str());
  } catch (const std::runtime_error& error) {  // direct readers of the file still work
    std::fprintf(stderr, "darwinop-virtual-robot: its camera is not available to other programs: %s\n", error.what());
  }
  return camera;
}

}  // namespace darwinop::app
