// Playback of motion files.
#include "webots/motion_playback.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "core/goals/present_goal.hpp"
#include "webots/Motor.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::webots_api {

namespace {

// Never destroyed: a motion may be a global object of the controller. Used by the robot's thread only.
std::vector<MotionPlayback*>& playbacks() {
  static auto* const list = new std::vector<MotionPlayback*>;
  return *list;
}

double inMs(Nanos time) {
  return std::chrono::duration<double, std::milli>(time).count();
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
  if (!valid_) return;
  const RobotImpl* const robot = currentRobot();
  const Nanos now = robot ? robot->session().time() : Nanos{0};
  const bool waited = now - std::exchange(asked_, now) >= duration();  // not so in a loop that calls it in each step
  if (!playing_) return begin();
  if (waited && !loop_) ++again_;
}

void MotionPlayback::begin() {
  if (isAtEnd()) time_ = start();
  last_.reset();
  lead_in_ = {};
  playing_ = true;
}

void MotionPlayback::setTime(std::chrono::milliseconds time) {
  time_ = std::clamp(time, std::chrono::milliseconds{0}, duration());
  if (isLeading()) last_.reset();  // a new slow move, from the present pose
}

void MotionPlayback::advance(RobotImpl& robot, Nanos now) {
  if (!playing_) return;
  if (!last_) lead_in_ = leadIn(robot);
  const Nanos passed = last_ ? std::max(now - *last_, Nanos{0}) : Nanos{0};
  const bool begun = last_.has_value();
  last_ = now;
  if (isLeading())
    lead_in_.advance(inMs(passed));
  else if (begun)
    goOn(passed);
  setMotors(robot);
  if (!isOver()) return;
  playing_ = false;
  if (again_ == 0) return;
  --again_;
  begin();
}

std::chrono::milliseconds MotionPlayback::leadInLeft() const {
  const RobotImpl* const robot = currentRobot();
  if (!playing_ || !robot) return {};
  const double left_ms = last_ ? (isLeading() ? lead_in_.remainingMs() : 0) : leadIn(*robot).durationMs();
  const int step_ms = std::max(1, robot->config().time_step_ms);
  return std::chrono::milliseconds{static_cast<std::int64_t>(std::ceil(left_ms / step_ms)) * step_ms};
}

void MotionPlayback::goOn(Nanos passed) {
  if (loop_ && isAtEnd()) time_ = start();
  time_ = std::clamp<Nanos>(time_ + (reverse_ ? -passed : passed), Nanos{0}, duration());
}

/// Value at the present playback time, or the first one later: without it the motor would jump there. Empty: none.
std::optional<double> MotionPlayback::leadInTarget(const MotionCurve& curve) const {
  return reverse_ ? curve.at(inMs(time_)) : curve.atOrFirst(inMs(time_));
}

/// Done at once if all motors are near. Motors without a value are not moved.
goals::LeadIn MotionPlayback::leadIn(const RobotImpl& robot) const {
  goals::LeadIn::Pose from{}, to{};
  double way = 0;
  for (const MotionCurve& curve : text_.curves) {
    const auto joint = findJoint(curve.motor);
    const auto rad = leadInTarget(curve);
    const auto* const motor = joint ? dynamic_cast<const webots::Motor*>(robot.find(curve.motor)) : nullptr;
    if (!motor || !rad) continue;
    const std::size_t i = index(*joint);
    from[i] = goals::presentGoal(*joint, robot.lastKnown(*joint), motor->getTargetPosition());
    to[i] = std::clamp(*rad, motor->getMinPosition(), motor->getMaxPosition());
    way = std::max(way, std::abs(to[i] - from[i]));
  }
  return way > kNear ? goals::LeadIn{from, to} : goals::LeadIn{};
}

void MotionPlayback::setMotors(RobotImpl& robot) const {
  for (const MotionCurve& curve : text_.curves) {
    const auto rad = isLeading() ? leadInTarget(curve) : curve.at(inMs(time_));
    auto* const motor = rad ? dynamic_cast<webots::Motor*>(robot.find(curve.motor)) : nullptr;
    if (motor) motor->setPosition(isLeading() ? lead_in_.at(index(*findJoint(curve.motor))) : *rad);
  }
}

void advanceMotions(RobotImpl& robot) {
  const Nanos now = robot.session().time();
  for (MotionPlayback* const playback : playbacks()) playback->advance(robot, now);
}

}  // namespace darwinop::webots_api
