// webots::Keyboard.
#include "webots/Keyboard.hpp"

#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "webots/key_queue.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/sampling_grid.hpp"

namespace webots {

namespace {
constexpr bool same(int here, darwinop::Key there) {
  return here == there;
}
static_assert(same(Keyboard::END, darwinop::kKeyEnd) && same(Keyboard::HOME, darwinop::kKeyHome) &&
              same(Keyboard::LEFT, darwinop::kKeyLeft) && same(Keyboard::UP, darwinop::kKeyUp) &&
              same(Keyboard::RIGHT, darwinop::kKeyRight) && same(Keyboard::DOWN, darwinop::kKeyDown) &&
              same(Keyboard::PAGEUP, darwinop::kKeyPageUp) && same(Keyboard::PAGEDOWN, darwinop::kKeyPageDown) &&
              same(Keyboard::NUMPAD_HOME, darwinop::kKeyNumpadHome) &&
              same(Keyboard::NUMPAD_LEFT, darwinop::kKeyNumpadLeft) &&
              same(Keyboard::NUMPAD_UP, darwinop::kKeyNumpadUp) &&
              same(Keyboard::NUMPAD_RIGHT, darwinop::kKeyNumpadRight) &&
              same(Keyboard::NUMPAD_DOWN, darwinop::kKeyNumpadDown) &&
              same(Keyboard::NUMPAD_END, darwinop::kKeyNumpadEnd) && same(Keyboard::KEY, darwinop::kKeyCodeMask) &&
              same(Keyboard::SHIFT, darwinop::kKeyShift) && same(Keyboard::CONTROL, darwinop::kKeyControl) &&
              same(Keyboard::ALT, darwinop::kKeyAlt));
}  // namespace

Keyboard::Keyboard(darwinop::webots_api::RobotImpl& robot) : robot_(&robot), period_(0), due_s_(-1), queue_(nullptr) {}

Keyboard::Keyboard() : robot_(nullptr), period_(0), due_s_(-1), queue_(nullptr) {}

/// The keyboard of the robot, if this object is not it; null: there is no robot.
Keyboard* Keyboard::ofRobot() const {
  darwinop::webots_api::RobotImpl* const robot = darwinop::webots_api::currentRobot();
  if (robot == nullptr) darwinop::webots_api::warnOnce(darwinop::webots_api::messages::kKeyboardWithoutRobot);
  return robot != nullptr ? &robot->keyboard() : nullptr;
}

Keyboard::~Keyboard() {
  delete queue_;
}

void Keyboard::enable(int sampling_period) {
  if (robot_ == nullptr) {
    if (Keyboard* const keyboard = ofRobot()) keyboard->enable(sampling_period);
    return;
  }
  if (sampling_period <= 0) return disable();
  period_ = sampling_period;
  due_s_ = -1;
  if (queue_ != nullptr) return;
  std::unique_ptr<darwinop::KeySource> source;
  try {
    source = robot_->openKeys();
  } catch (const std::exception& error) {
    darwinop::webots_api::warnOnce(std::string{"Keyboard: no key is ever pressed: "} + error.what());
  }
  queue_ = new darwinop::webots_api::KeyQueue(std::move(source));
}

void Keyboard::disable() {
  if (robot_ == nullptr) {
    if (Keyboard* const keyboard = ofRobot()) keyboard->disable();
    return;
  }
  period_ = 0;
  delete std::exchange(queue_, nullptr);
}

void Keyboard::refresh(double time_s) {
  if (queue_ != nullptr && darwinop::webots_api::isDue(due_s_, time_s, period_)) queue_->refresh();
}

int Keyboard::getSamplingPeriod() const {
  if (robot_ != nullptr) return period_;
  const Keyboard* const keyboard = ofRobot();
  return keyboard != nullptr ? keyboard->period_ : 0;
}

int Keyboard::getKey() const {
  if (robot_ == nullptr) {
    const Keyboard* const keyboard = ofRobot();
    return keyboard != nullptr ? keyboard->getKey() : -1;
  }
  return queue_ != nullptr ? queue_->next() : -1;
}

}  // namespace webots
