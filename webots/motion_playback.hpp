// A motion file being played: the clock of one webots::Motion, and the list of them that Robot::step() drives.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "core/goals/lead_in.hpp"
#include "core/joints.hpp"
#include "hal/byte_line.hpp"
#include "webots/motion_text.hpp"

namespace darwinop::webots_api {

class RobotImpl;

/// Alive, it is on the list; it moves motors between play() and its end or stop(), and at no other time.
class MotionPlayback {
 public:
  /// Says what is wrong with the file, and which of its motors the robot does not have.
  explicit MotionPlayback(const std::string& file);
  ~MotionPlayback();
  MotionPlayback(const MotionPlayback&) = delete;
  MotionPlayback& operator=(const MotionPlayback&) = delete;

  [[nodiscard]] bool isValid() const { return valid_; }
  void play();
  void stop() { playing_ = false; }
  void setLoop(bool loop) { loop_ = loop; }
  void setReverse(bool reverse) { reverse_ = reverse; }
  void setTime(std::chrono::milliseconds time);
  [[nodiscard]] std::chrono::milliseconds duration() const { return std::chrono::milliseconds{text_.duration_ms}; }
  [[nodiscard]] Nanos time() const { return time_; }
  [[nodiscard]] bool isOver() const { return !valid_ || (!loop_ && isAtEnd() && !isLeading()); }

  /// A motor farther from its first value than this, rad, is led there: 5.7 degrees.
  static constexpr double kNear = 0.1;

  /// A step of the robot begins. The first one after play() sets the pose of the present time, each further one that
  /// of as much later as the robot's clock has gone on. If that first pose is far away, all motors are led there
  /// before, and the time stands still meanwhile.
  void advance(RobotImpl& robot, Nanos now);

 private:
  [[nodiscard]] Nanos start() const { return reverse_ ? duration() : Nanos{0}; }
  [[nodiscard]] bool isAtEnd() const { return time_ == (reverse_ ? Nanos{0} : Nanos{duration()}); }
  [[nodiscard]] bool isLeading() const { return playing_ && !lead_in_.done(); }
  [[nodiscard]] goals::LeadIn leadIn(const RobotImpl& robot) const;
  void goOn(Nanos passed);
  void setMotors(RobotImpl& robot) const;

  MotionText text_;
  bool valid_ = false, playing_ = false, loop_ = false, reverse_ = false;
  Nanos time_{0};              // 0 to duration()
  std::optional<Nanos> last_;  // of the robot's clock, in the step before; none: not since play()
  goals::LeadIn lead_in_;
};

/// Once per step, before the motors' commands are computed. If two move one motor, the newer one wins.
void advanceMotions(RobotImpl& robot);

}  // namespace darwinop::webots_api
