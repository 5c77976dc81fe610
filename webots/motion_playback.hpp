// Playback of a motion file: time and state of one webots::Motion, and the list of them that Robot::step() advances.
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

/// On the list during its lifetime. Moves motors only between play() and its end or stop().
class MotionPlayback {
 public:
  /// Logs errors in the file, and motors of the file that the robot does not have.
  explicit MotionPlayback(const std::string& file);
  ~MotionPlayback();
  MotionPlayback(const MotionPlayback&) = delete;
  MotionPlayback& operator=(const MotionPlayback&) = delete;

  [[nodiscard]] bool isValid() const { return valid_; }
  /// While it plays, without effect, unless it were over by now without the slow move to its first pose: then a
  /// controller has waited for the file's duration, and the motion is played once more after its end.
  void play();
  void stop() {
    playing_ = false;
    again_ = 0;
  }
  void setLoop(bool loop) { loop_ = loop; }
  void setReverse(bool reverse) { reverse_ = reverse; }
  void setTime(std::chrono::milliseconds time);
  [[nodiscard]] std::chrono::milliseconds duration() const { return std::chrono::milliseconds{text_.duration_ms}; }
  /// What the slow move to the first pose still takes, in whole time steps; before the first step after play(), what it
  /// will take.
  [[nodiscard]] std::chrono::milliseconds leadInLeft() const;
  [[nodiscard]] Nanos time() const { return time_; }
  [[nodiscard]] bool isOver() const { return !valid_ || (!loop_ && isAtEnd() && !isLeading()); }

  /// Maximum distance of a motor from its first value, at any time, without a slow move there, rad: 5.7 degrees.
  static constexpr double kNear = 0.1;

  /// Called at the start of each step. The first call after play() sets the pose of the present playback time; each
  /// further call advances it by the time that passed on the robot's clock. If the first pose is far away, all motors
  /// move there slowly first, and playback time stands still meanwhile.
  void advance(RobotImpl& robot, Nanos now);

 private:
  [[nodiscard]] Nanos start() const { return reverse_ ? duration() : Nanos{0}; }
  [[nodiscard]] bool isAtEnd() const { return time_ == (reverse_ ? Nanos{0} : Nanos{duration()}); }
  [[nodiscard]] bool isLeading() const { return playing_ && !lead_in_.done(); }
  [[nodiscard]] goals::LeadIn leadIn(const RobotImpl& robot) const;
  [[nodiscard]] std::optional<double> leadInTarget(const MotionCurve& curve) const;
  void begin();
  void goOn(Nanos passed);
  void setMotors(RobotImpl& robot) const;

  MotionText text_;
  bool valid_ = false, playing_ = false, loop_ = false, reverse_ = false;
  Nanos time_{0};              // 0 to duration()
  std::optional<Nanos> last_;  // robot's clock in the previous step; empty: no step since play()
  Nanos asked_{0};             // robot's clock at play()
  int again_ = 0;              // repetitions after its end
  goals::LeadIn lead_in_;
};

/// Advances all motions. Call once per step, before the motors' commands are computed. If two motions move the same
/// motor, the newer one wins.
void advanceMotions(RobotImpl& robot);

}  // namespace darwinop::webots_api
