// A motion file being played: the clock of one webots::Motion, and the list of them that Robot::step() drives.
#include "webots/motion_playback.hpp"

#include <algorithm>
#include <stdexcept>

#include "webots/Motor.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::facade {

namespace {

// Never destroyed: a motion may be a global object of the controller. One thread uses it, that of the robot.
std::vector<MotionPlayback*>& playbacks() {
  static auto* const list = new std::vector<MotionPlayback*>;
  return *list;
}

void nameMissing(const std::string& file, const MotionText& text) {
  std::string missing;
  for (const MotionCurve& curve : text.curves)
    if (!findJoint(curve.motor)) missing += (missing.empty() ? "" : ", ") + curve.motor;
  if (!missing.empty()) warnOnce("Motion: " + file + ": this robot has no motor " + missing + "; it is left out");
}

}  // namespace

MotionPlayback::MotionPlayback(const std::string& file) {
  playbacks().push_back(this);
  try {
    text_ = readMotion(file);
    valid_ = true;
    nameMissing(file, text_);
  } catch (const std::runtime_error& why) {
    warnOnce(std::string{"Motion: "} + why.what() + "; it will not be played");
  }
}

MotionPlayback::~MotionPlayback() {
  std::erase(playbacks(), this);
}

void MotionPlayback::play() {
  if (!valid_ || playing_) return;
  if (isAtEnd()) time_ = start();
  last_.reset();
  playing_ = true;
}

void MotionPlayback::setTime(std::chrono::milliseconds time) {
  time_ = std::clamp(time, std::chrono::milliseconds{0}, duration());
}

void MotionPlayback::advance(RobotImpl& robot, Nanos now) {
  if (!playing_) return;
  if (last_) {
    if (loop_ && isAtEnd()) time_ = start();
    const Nanos passed = std::max(now - *last_, Nanos{0});
    time_ = std::clamp<Nanos>(time_ + (reverse_ ? -passed : passed), Nanos{0}, duration());
  }
  last_ = now;
  setMotors(robot);
  if (isOver()) playing_ = false;
}

void MotionPlayback::setMotors(RobotImpl& robot) const {
  const double ms = std::chrono::duration<double, std::milli>(time_).count();
  for (const MotionCurve& curve : text_.curves) {
    const auto rad = curve.at(ms);
    auto* const motor = rad ? dynamic_cast<webots::Motor*>(robot.find(curve.motor)) : nullptr;
    if (motor) motor->setPosition(*rad);
  }
}

void advanceMotions(RobotImpl& robot) {
  const Nanos now = robot.session().time();
  for (MotionPlayback* const playback : playbacks()) playback->advance(robot, now);
}

}  // namespace darwinop::facade
