// Plays a .motion file: docs/motions.md.
#ifndef MOTION_HPP
#define MOTION_HPP

#ifndef WB_USING_CPP_API
#define WB_USING_CPP_API
#endif

#include <string>

namespace darwinop {
namespace facade {
class MotionPlayback;
}
}  // namespace darwinop

namespace webots {

/// Between play() and its end, or stop(), each Robot::step() moves the motors that the file names. At any other time
/// they are the controller's.
class Motion {
 public:
  /// A relative name is looked for beside the program.
  explicit Motion(const std::string& fileName);
  virtual ~Motion();
  /// False: the file is missing or broken, which was said with its line and field. The other calls then do nothing.
  bool isValid() const;
  /// Goes on from the present time; from the beginning when it is at the end (from the end when reversed). Motors that
  /// are far from there are led there slowly, and the time waits.
  virtual void play();
  /// Keeps the present time and the goals that the motors have.
  virtual void stop();
  /// At its end it begins anew. Not looped (default): it is over there.
  virtual void setLoop(bool loop);
  /// The clock runs backwards.
  virtual void setReverse(bool reverse);
  /// ms, brought into 0 to getDuration().
  virtual void setTime(int time);
  /// ms.
  int getDuration() const;
  int getTime() const;
  /// True at the end (at the beginning when reversed), unless it is looped; true if the file is not valid.
  bool isOver() const;

 private:
  Motion(const Motion&);
  Motion& operator=(const Motion&);
  darwinop::facade::MotionPlayback* playback_;  // never NULL
};

}  // namespace webots

#endif
