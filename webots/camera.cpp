// The camera in the head: all calls, no picture yet.
#include "webots/Camera.hpp"

#include <limits>

#include "webots/Node.hpp"
#include "webots/config_ini.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

using darwinop::facade::warnOnce;

Camera::Camera(const std::string& name, darwinop::facade::RobotImpl& robot, int width, int height)
    : Device(name, Node::CAMERA, robot), width_(width), height_(height), period_(0) {}

Camera::~Camera() = default;

void Camera::enable(int sampling_period) {
  warnOnce("Camera: this version has no pictures yet; getImage() returns a black one");
  period_ = sampling_period;
  if (!frame_.empty()) return;
  frame_.assign(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), '\0');
  for (std::size_t alpha = 3; alpha < frame_.size(); alpha += 4) frame_[alpha] = '\xFF';
}

void Camera::disable() {
  period_ = 0;
}

const unsigned char* Camera::getImage() const {
  return period_ > 0 ? reinterpret_cast<const unsigned char*>(frame_.data()) : nullptr;
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
  warnOnce("Camera::getExposure() returns NaN: this version does not know it");
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
  warnOnce("Camera::saveImage() saves nothing: this version has no pictures yet");
  return -1;
}

bool Camera::checkResolution(int width, int height) {
  return darwinop::facade::cameraHasSize(width, height);
}

}  // namespace webots
