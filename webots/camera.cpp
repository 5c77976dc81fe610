// webots::Camera: the camera in the head.
#include "webots/Camera.hpp"

#include <exception>
#include <limits>
#include <memory>
#include <utility>

#include "webots/Node.hpp"
#include "webots/camera_view.hpp"
#include "webots/config_ini.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/sampling_grid.hpp"

namespace webots {

using darwinop::webots_api::CameraView;
using darwinop::webots_api::warnOnce;

Camera::Camera(const std::string& name, darwinop::webots_api::RobotImpl& robot, int width, int height)
    : Device(name, Node::CAMERA, robot), width_(width), height_(height), period_(0), due_s_(-1), view_(nullptr) {}

Camera::~Camera() {
  delete view_;
}

void Camera::enable(int sampling_period) {
  if (sampling_period <= 0) return disable();
  period_ = sampling_period;
  due_s_ = -1;
  if (view_ != nullptr) return;
  std::unique_ptr<darwinop::FrameSource> source;
  try {
    source = robot_.openCamera(width_, height_);
  } catch (const std::exception& error) {
    warnOnce(std::string{"Camera: every picture is black: "} + error.what());
  }
  view_ = new CameraView(width_, height_, std::move(source));
}

void Camera::disable() {
  period_ = 0;
  delete std::exchange(view_, nullptr);
}

void Camera::refresh() {
  const double time_s = robot_.seconds();
  if (view_ == nullptr || !darwinop::webots_api::isDue(due_s_, time_s, period_)) return;
  const std::string error = view_->refresh();
  if (!error.empty()) darwinop::webots_api::logLine(error);
}

const unsigned char* Camera::getImage() const {
  return view_ != nullptr ? view_->bgra() : nullptr;
}

int Camera::getWidth() const {
  return width_;
}
int Camera::getHeight() const {
  return height_;
}

void Camera::setFov(double) {
  warnOnce("Camera::setFov() has no effect: the lens is fixed");
}

double Camera::getExposure() const {
  warnOnce("Camera::getExposure() returns NaN: this version does not read it");
  return std::numeric_limits<double>::quiet_NaN();
}

void Camera::setExposure(double) {
  warnOnce("Camera::setExposure() has no effect in this version");
}

double Camera::getFocalLength() const {
  warnOnce("Camera::getFocalLength() returns 0: the lens is fixed and its length is not known");
  return 0;
}

double Camera::getFocalDistance() const {
  warnOnce("Camera::getFocalDistance() returns 0: the lens is fixed");
  return 0;
}

double Camera::getMaxFocalDistance() const {
  return 0;
}
double Camera::getMinFocalDistance() const {
  return 0;
}
void Camera::setFocalDistance(double) {
  warnOnce("Camera::setFocalDistance() has no effect: the lens is fixed");
}

int Camera::saveImage(const std::string&, int) const {
  warnOnce("Camera::saveImage() saves nothing in this version");
  return -1;
}

bool Camera::checkResolution(int width, int height) {
  return darwinop::webots_api::cameraHasSize(width, height);
}

}  // namespace webots
