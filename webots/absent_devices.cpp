// Devices of the simulator that this robot does not have: what the classes of absent_devices.hpp, Robot, Camera,
// Joystick and Mouse return instead.
#include <cstdio>
#include <limits>

#include "webots/Camera.hpp"
#include "webots/GPS.hpp"
#include "webots/Joystick.hpp"
#include "webots/Mouse.hpp"
#include "webots/Robot.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"

namespace darwinop::webots_api {

double absentNumber() {
  return std::numeric_limits<double>::quiet_NaN();
}

const double* absentNumbers() {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kNumbers[] = {kNan, kNan, kNan, kNan};
  return kNumbers;
}

}  // namespace darwinop::webots_api

namespace webots {

using darwinop::webots_api::warnOnce;
namespace messages = darwinop::webots_api::messages;

Joystick* Robot::getJoystick() const {
  static Joystick joystick;
  warnOnce(messages::kNoJoystick);
  return &joystick;
}

Mouse* Robot::getMouse() const {
  static Mouse mouse;
  warnOnce(messages::kNoMouse);
  return &mouse;
}

void Joystick::enable(int sampling_period) {
  warnOnce(messages::kNoJoystick);
  period_ = sampling_period;
}
void Joystick::disable() {
  period_ = 0;
}
int Joystick::getAxisValue(int) const {
  return 0;
}
int Joystick::getPovValue(int) const {
  return 0;
}
void Joystick::setConstantForce(int) {}
void Joystick::setConstantForceDuration(double) {}
void Joystick::setAutoCenteringGain(double) {}
void Joystick::setResistanceGain(double) {}
void Joystick::setForceAxis(int) {}

void Mouse::enable(int sampling_period) {
  warnOnce(messages::kNoMouse);
  period_ = sampling_period;
}
void Mouse::disable() {
  period_ = 0;
}

MouseState Mouse::getState() const {
  const double unknown = darwinop::webots_api::absentNumber();
  return {false, false, false, unknown, unknown, unknown, unknown, unknown};
}

void Camera::recognitionEnable(int) {
  warnOnce(messages::kNoRecognition);
}
void Camera::enableRecognitionSegmentation() {
  warnOnce(messages::kNoRecognition);
}
int Camera::saveRecognitionSegmentationImage(const std::string&, int) const {
  warnOnce(messages::kNoRecognition);
  return -1;
}

std::string GPS::convertToDegreesMinutesSeconds(double decimal_degrees) {
  const double minutes = (decimal_degrees - static_cast<int>(decimal_degrees)) * 60;
  const double seconds = (minutes - static_cast<int>(minutes)) * 60;
  char text[64];
  std::snprintf(text, sizeof text, "%d° %d′ %d″", static_cast<int>(decimal_degrees), static_cast<int>(minutes),
                static_cast<int>(seconds));
  return text;
}

}  // namespace webots
