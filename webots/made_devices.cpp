// Devices as controllers get them: the robot's own objects, or those of a class that overrides Robot::createLED() and
// its siblings, and the constructors of such objects.
#include <algorithm>
#include <cstdlib>

#include "webots/Accelerometer.hpp"
#include "webots/Altimeter.hpp"
#include "webots/Brake.hpp"
#include "webots/Camera.hpp"
#include "webots/Compass.hpp"
#include "webots/Connector.hpp"
#include "webots/Display.hpp"
#include "webots/DistanceSensor.hpp"
#include "webots/Emitter.hpp"
#include "webots/GPS.hpp"
#include "webots/Gyro.hpp"
#include "webots/InertialUnit.hpp"
#include "webots/LED.hpp"
#include "webots/Lidar.hpp"
#include "webots/LightSensor.hpp"
#include "webots/Node.hpp"
#include "webots/Pen.hpp"
#include "webots/PositionSensor.hpp"
#include "webots/Radar.hpp"
#include "webots/RangeFinder.hpp"
#include "webots/Receiver.hpp"
#include "webots/Servo.hpp"
#include "webots/Skin.hpp"
#include "webots/Speaker.hpp"
#include "webots/TouchSensor.hpp"
#include "webots/VacuumGripper.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/sound_desk.hpp"

namespace webots {

namespace webots_api = darwinop::webots_api;

namespace {
/// `LED("EyeLed")`, as a controller has written it.
std::string call(const std::string& name, const char* type) {
  return std::string{type} + "(\"" + name + "\")";
}

/// The robot that a device made by name belongs to; ends the program without one.
webots_api::RobotImpl& robotOf(const std::string& name, const char* type) {
  if (webots_api::RobotImpl* const robot = webots_api::currentRobot()) return *robot;
  webots_api::logLine(call(name, type) + webots_api::messages::kNoRobotYet);
  std::exit(EXIT_FAILURE);
}

/// The robot's own object for a device that a controller makes by name; ends the program without one.
template <class T>
const T* ofTheRobot(const std::string& name, const char* type) {
  if (const auto* device = dynamic_cast<const T*>(robotOf(name, type).find(name))) return device;
  webots_api::logLine(call(name, type) + webots_api::messages::kNoDeviceToMake);
  std::exit(EXIT_FAILURE);
}
}  // namespace

// The getter returns what the maker returned first; by default that is the robot's own object, or NULL if it has none.
#define DARWINOP_DEVICE(CLASS)                                           \
  CLASS* Robot::get##CLASS(const std::string& name) const {              \
    auto*& made = impl_->made("get" #CLASS, name);                       \
    if (made == nullptr) made = impl_->keep(create##CLASS(name));        \
    auto* const device = dynamic_cast<CLASS*>(made);                     \
    if (device == nullptr) webots_api::warnNoDevice("get" #CLASS, name); \
    return device;                                                       \
  }                                                                      \
  CLASS* Robot::create##CLASS(const std::string& name) const {           \
    return dynamic_cast<CLASS*>(impl_->find(name));                      \
  }
DARWINOP_DEVICE(Accelerometer)
DARWINOP_DEVICE(Camera)
DARWINOP_DEVICE(Gyro)
DARWINOP_DEVICE(LED)
DARWINOP_DEVICE(Motor)
DARWINOP_DEVICE(PositionSensor)
DARWINOP_DEVICE(Servo)
DARWINOP_DEVICE(Speaker)
DARWINOP_DEVICE(TouchSensor)
DARWINOP_ABSENT_DEVICES(DARWINOP_DEVICE)
#undef DARWINOP_DEVICE

Device* Robot::getDevice(const std::string& name) const {
  Device* const device = impl_->find(name);
  if (device == nullptr) webots_api::warnNoDevice("getDevice", name);
  if (dynamic_cast<Accelerometer*>(device) != nullptr) return getAccelerometer(name);
  if (dynamic_cast<Camera*>(device) != nullptr) return getCamera(name);
  if (dynamic_cast<Gyro*>(device) != nullptr) return getGyro(name);
  if (dynamic_cast<LED*>(device) != nullptr) return getLED(name);
  if (dynamic_cast<Motor*>(device) != nullptr) return getMotor(name);
  if (dynamic_cast<PositionSensor*>(device) != nullptr) return getPositionSensor(name);
  if (dynamic_cast<Speaker*>(device) != nullptr) return getSpeaker(name);
  if (dynamic_cast<TouchSensor*>(device) != nullptr) return getTouchSensor(name);
  return device;
}

Device* Robot::getDeviceByIndex(int index) const {
  if (index < 0 || index >= getNumberOfDevices()) return nullptr;
  return getDevice(impl_->devices()[static_cast<std::size_t>(index)]->getName());
}

Device::Device(const Device* of_the_robot)
    : robot_(of_the_robot->robot_),
      name_(of_the_robot->name_),
      node_type_(of_the_robot->node_type_),
      tag_(of_the_robot->tag_) {
  robot_.addSecond(this);
}

Device::Device(const std::string& name, const char* type)
    : robot_(robotOf(name, type)), name_(name), node_type_(Node::NO_NODE), tag_(0) {
  robot_.addSecond(this);
  webots_api::warnOnce(call(name, type) + webots_api::messages::kAbsentDevice);
}

Device::~Device() {
  if (webots_api::currentRobot() == &robot_) robot_.removeSecond(this);
}

Accelerometer::Accelerometer(const std::string& name)
    : Device(ofTheRobot<Accelerometer>(name, "Accelerometer")), values_(), lookup_(), period_(0) {
  std::ranges::copy(ofTheRobot<Accelerometer>(name, "Accelerometer")->lookup_, lookup_);
  Accelerometer::refresh();
}

Camera::Camera(const std::string& name)
    : Device(ofTheRobot<Camera>(name, "Camera")),
      width_(ofTheRobot<Camera>(name, "Camera")->width_),
      height_(ofTheRobot<Camera>(name, "Camera")->height_),
      period_(0),
      due_s_(-1),
      view_(nullptr) {}

Gyro::Gyro(const std::string& name) : Device(ofTheRobot<Gyro>(name, "Gyro")), values_(), lookup_(), period_(0) {
  std::ranges::copy(ofTheRobot<Gyro>(name, "Gyro")->lookup_, lookup_);
  Gyro::refresh();
}

LED::LED(const std::string& name)
    : Device(ofTheRobot<LED>(name, "LED")),
      which_(ofTheRobot<LED>(name, "LED")->which_),
      panel_bit_(ofTheRobot<LED>(name, "LED")->panel_bit_),
      value_(0),
      set_(false) {}

Motor::Motor(const std::string& name)
    : Device(ofTheRobot<Motor>(name, "Motor")),
      control_(ofTheRobot<Motor>(name, "Motor")->control_),
      torque_period_(0),
      position_period_(0) {}

PositionSensor::PositionSensor(const std::string& name)
    : Device(ofTheRobot<PositionSensor>(name, "PositionSensor")),
      joint_(ofTheRobot<PositionSensor>(name, "PositionSensor")->joint_),
      period_(0) {}

Servo::Servo(const std::string& name) : Motor(ofTheRobot<Servo>(name, "Servo")->getName()) {}

Speaker::Speaker(const std::string& name)
    : Device(ofTheRobot<Speaker>(name, "Speaker")),
      language_("en"),
      desk_(new webots_api::SoundDesk([this] { return robot_.open_sound(); })) {}

TouchSensor::TouchSensor(const std::string& name)
    : Device(ofTheRobot<TouchSensor>(name, "TouchSensor")),
      bit_(ofTheRobot<TouchSensor>(name, "TouchSensor")->bit_),
      period_(0) {}

}  // namespace webots
