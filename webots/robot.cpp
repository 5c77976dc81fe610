// webots::Robot.
#include "webots/Robot.hpp"

#include "webots/Accelerometer.hpp"
#include "webots/Camera.hpp"
#include "webots/Gyro.hpp"
#include "webots/Keyboard.hpp"
#include "webots/LED.hpp"
#include "webots/Motor.hpp"
#include "webots/Node.hpp"
#include "webots/PositionSensor.hpp"
#include "webots/Servo.hpp"
#include "webots/Speaker.hpp"
#include "webots/TouchSensor.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

namespace webots_api = darwinop::webots_api;
using webots_api::warnOnce;

namespace {
Robot* instance = nullptr;

template <class T>
T* deviceAs(const webots_api::RobotImpl& robot, const std::string& name, const char* call) {
  auto* const device = dynamic_cast<T*>(robot.find(name));
  if (!device) webots_api::warnNoDevice(call, name);
  return device;
}
}  // namespace

Robot::Robot() : impl_(webots_api::connectOrExit()) {
  instance = this;
}
Robot::Robot(webots_api::RobotImpl* impl) : impl_(webots_api::adopt(impl)) {
  instance = this;
}

Robot::~Robot() {
  if (instance == this) instance = nullptr;
  webots_api::release(impl_);
}

Robot* Robot::getInstance() {
  return instance;
}

int Robot::step(int duration) {
  impl_->stepBegin(duration);
  return impl_->stepEnd();
}

int Robot::stepBegin(int duration) {
  impl_->stepBegin(duration);
  return 0;
}

int Robot::stepEnd() {
  return impl_->stepEnd();
}

std::string Robot::getName() const {
  return "darwin-op";
}
std::string Robot::getModel() const {
  return "DARwIn-OP";
}
int Robot::getType() const {
  return Node::ROBOT;
}

double Robot::getTime() const {
  const auto ms = std::chrono::round<std::chrono::milliseconds>(impl_->session().time());
  return static_cast<double>(ms.count()) / 1000;
}

double Robot::getBasicTimeStep() const {
  return impl_->config().time_step_ms;
}

Accelerometer* Robot::getAccelerometer(const std::string& name) const {
  return deviceAs<Accelerometer>(*impl_, name, "getAccelerometer");
}
Camera* Robot::getCamera(const std::string& name) const {
  return deviceAs<Camera>(*impl_, name, "getCamera");
}
Gyro* Robot::getGyro(const std::string& name) const {
  return deviceAs<Gyro>(*impl_, name, "getGyro");
}
Keyboard* Robot::getKeyboard() const {
  return &impl_->keyboard();
}
LED* Robot::getLED(const std::string& name) const {
  return deviceAs<LED>(*impl_, name, "getLED");
}
Motor* Robot::getMotor(const std::string& name) const {
  return deviceAs<Motor>(*impl_, name, "getMotor");
}
PositionSensor* Robot::getPositionSensor(const std::string& name) const {
  return deviceAs<PositionSensor>(*impl_, name, "getPositionSensor");
}
Servo* Robot::getServo(const std::string& name) const {
  return deviceAs<Servo>(*impl_, name, "getServo");
}
Speaker* Robot::getSpeaker(const std::string& name) const {
  return deviceAs<Speaker>(*impl_, name, "getSpeaker");
}
TouchSensor* Robot::getTouchSensor(const std::string& name) const {
  return deviceAs<TouchSensor>(*impl_, name, "getTouchSensor");
}
Device* Robot::getDevice(const std::string& name) const {
  return deviceAs<Device>(*impl_, name, "getDevice");
}

int Robot::getNumberOfDevices() const {
  return static_cast<int>(impl_->devices().size());
}

Device* Robot::getDeviceByIndex(int index) const {
  if (index < 0 || index >= getNumberOfDevices()) return nullptr;
  return impl_->devices()[static_cast<std::size_t>(index)].get();
}

void Robot::batterySensorEnable(int sampling_period) {
  impl_->battery_period = sampling_period;
}
void Robot::batterySensorDisable() {
  impl_->battery_period = 0;
}
int Robot::batterySensorGetSamplingPeriod() const {
  return impl_->battery_period;
}

double Robot::batterySensorGetValue() const {
  const auto* board = impl_->board("the battery sensor");
  return board ? board->voltage.value : darwinop::kUnknown;
}

void Robot::keyboardEnable(int sampling_period) {
  impl_->keyboard().enable(sampling_period);
}
void Robot::keyboardDisable() {
  impl_->keyboard().disable();
}

int Robot::keyboardGetKey() const {
  const int key = impl_->keyboard().getKey();
  return key < 0 ? 0 : key;
}

std::string Robot::getProjectPath() const {
  return webots_api::programDirectory();
}
std::string Robot::getCustomData() const {
  return impl_->custom_data;
}
void Robot::setCustomData(const std::string& data) {
  impl_->custom_data = data;
}
std::string Robot::getData() const {
  return impl_->custom_data;
}
void Robot::setData(const std::string& data) {
  impl_->custom_data = data;
}

std::string Robot::getWorldPath() const {
  warnOnce("Robot::getWorldPath() returns an empty text: a robot has no world file");
  return {};
}

std::string Robot::getUrdf(std::string) const {
  warnOnce("Robot::getUrdf() returns an empty text in this version");
  return {};
}

void Robot::setMode(Mode, const char*) {
  warnOnce("Robot::setMode() has no effect: choose with DARWINOP_ROBOT");
}

Robot::UserInputEvent Robot::waitForUserInputEvent(UserInputEvent, int) {
  warnOnce("Robot::waitForUserInputEvent() does not wait in this version: it returns EVENT_NO_EVENT");
  return EVENT_NO_EVENT;
}

void Robot::wwiSend(const char*, int) {
  warnOnce("Robot::wwiSend() has no effect: there is no robot window yet");
}
void Robot::wwiSendText(const std::string&) {
  warnOnce("Robot::wwiSendText() has no effect: there is no robot window yet");
}

const char* Robot::wwiReceive(int* size) {
  warnOnce("Robot::wwiReceive() returns NULL: there is no robot window yet");
  if (size) *size = 0;
  return nullptr;
}

std::string Robot::wwiReceiveText() {
  warnOnce("Robot::wwiReceiveText() returns an empty text: there is no robot window yet");
  return {};
}

void* Robot::windowCustomFunction(void*) {
  warnOnce("Robot::windowCustomFunction() returns NULL: there is no robot window yet");
  return nullptr;
}

}  // namespace webots
