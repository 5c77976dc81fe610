// Plays a .motion file: docs/motions.md.
#ifndef MOTION_HPP
#define MOTION_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace darwinop {
namespace webots_api {
class MotionPlayback;
}
}  // namespace darwinop

namespace webots {

///     webots::Motion wave("wave.motion");
///     wave.play();
///     while (!wave.isOver() && robot.step(16) != -1) {
///     }
///
/// Between play() and its end, or stop(), each Robot::step() sets the goals of the motors that the file names, through
/// the same safety layer as any other goal. At any other time the controller may set them. Simulator: the same, but
/// without the slow approach of the first pose. Threads: see Robot.
class Motion {
 public:
  /// Reads the file; a relative name starts at the directory of the program. Motors that this robot does not have are
  /// skipped with one warning.
  explicit Motion(const std::string& fileName);
  virtual ~Motion();
  /// False: the file is missing or wrong; the constructor logged file, line and field. The other calls then do nothing.
  bool isValid() const;
  /// Continues from the current time; at the end it starts from the beginning (reversed: from the end). Motors that are
  /// far from their first goals, also from those in later poses, move there first, at 1.194 rad/s at most, while the
  /// motion's time stands still. While it plays, without effect; but once the file's length has passed since the last
  /// play() it will be played again after its end, so that the slow move takes nothing from a sequence of
  /// `play(); wait(getDuration())`.
  virtual void play();
  /// Pauses; the motors keep their goals.
  virtual void stop();
  /// True: restarts at its end. False (default): ends there.
  virtual void setLoop(bool loop);
  /// True: plays backwards. Default false.
  virtual void setReverse(bool reverse);
  /// Sets the current time in ms, clamped to 0 and the length of the file.
  virtual void setTime(int time);
  /// Length in ms; 0 if the file is not valid. Between play() and the first pose of the file it includes what the slow
  /// move there still takes, so that `play(); wait(getDuration())` waits for the end.
  int getDuration() const;
  /// Current time in ms, 0 to getDuration().
  int getTime() const;
  /// True at the end (reversed: at the beginning) unless looped; true if the file is not valid.
  bool isOver() const;

 private:
  Motion(const Motion&);
  Motion& operator=(const Motion&);
  darwinop::webots_api::MotionPlayback* playback_;  // never NULL
};

}  // namespace webots

#endif
