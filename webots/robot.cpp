// webots::Robot.
#include "webots/Robot.hpp"

#include <fstream>

#include "webots/Keyboard.hpp"
#include "webots/Node.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace webots {

namespace webots_api = darwinop::webots_api;
using webots_api::warnOnce;

namespace {
Robot* instance = nullptr;

/// Name of the program without its folder, then its arguments.
std::vector<std::string> programArguments() {
  std::ifstream in{"/proc/self/cmdline", std::ios::binary};
  std::vector<std::string> arguments;
  for (std::string argument; std::getline(in, argument, '\0');) arguments.push_back(argument);
  if (arguments.empty()) arguments.emplace_back();
  arguments.front().erase(0, arguments.front().rfind('/') + 1);
  return arguments;
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

Keyboard* Robot::getKeyboard() const {
  return &impl_->keyboard();
}

int Robot::getNumberOfDevices() const {
  return static_cast<int>(impl_->devices().size());
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
std::string Robot::getControllerName() const {
  return programArguments().front();
}

std::string Robot::getControllerArguments() const {
  const std::vector<std::string> arguments = programArguments();
  std::string joined;
  for (std::size_t i = 1; i < arguments.size(); ++i) joined += (i > 1 ? " " : "") + arguments[i];
  return joined;
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
