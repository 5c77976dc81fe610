// Plays the pages of a motion file: docs/motions.md.
#ifndef DARWIN_OP_MOTION_MANAGER_HPP
#define DARWIN_OP_MOTION_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

///     managers::DARwInOPMotionManager pages(&robot);
///     pages.playPage(9);                        // blocks until the page has ended
///     pages.playPage(24, false);                // returns at once
///     while (pages.isMotionPlaying()) {
///       if (robot.step(16) == -1) return 1;     // plays it, unless the controller calls pages.step()
///     }
///
/// While a page is played, it sets goals and P gains of all 20 joints, through the safety layer as any other goal. It
/// starts from the robot's current goals, so that goals do not jump. When it has ended the goals stay, and the P gains
/// are those of the controller again. While the robot does not follow, as with a silent board, a page waits. After
/// 0.3 s it ends there, with one message: isMotionPlaying() is false, and playPage() returns.
///
/// 2013: the same timing of pages; it ignored customMotionFile and did not approach a first pose slowly. Simulator: no
/// slow approach either; it ignores speed, profile and gains, so pages of another speed than 32 last up to 2.5 times
/// longer there. Errors are logged once on stderr, nothing is thrown. Threads: all calls from the thread of the Robot.
class DARwInOPMotionManager {
 public:
  /// Reads the motion file: customMotionFile, binary or text, or "own" for the built-in pages. With "" it reads
  /// motion_4096.bin in the data directory, and uses the built-in pages if that does not exist.
  explicit DARwInOPMotionManager(webots::Robot* robot, const std::string& customMotionFile = "");
  /// The same pages and robot; the copy does not play.
  DARwInOPMotionManager(const DARwInOPMotionManager& other);
  /// As the copy constructor; a page that this object plays ends.
  DARwInOPMotionManager& operator=(const DARwInOPMotionManager& other);
  virtual ~DARwInOPMotionManager();

  /// False: there is no robot, the named file is missing, or it is not a motion file (logged with byte or line).
  /// Nothing will be played. A damaged page of a binary file, such as one with a wrong checksum, is logged and counts
  /// as empty.
  bool isCorrectlyInitialized();
  /// Plays page `id`, 1 to 255. `sync`: blocks, calling Robot::step() with the basic time step, until the page and the
  /// pages that follow it have ended, or until step() returns -1. Not `sync`: returns at once, and Robot::step() plays
  /// it, or step() once that was called. A first pose that is far away is approached slowly before the page starts. An
  /// empty page, and a page while another one is played, are refused with one warning.
  void playPage(int id, bool sync = true);
  /// Continues a page that was not started with `sync` by `ms` ms (in the simulator by one of its steps); from the
  /// first call on Robot::step() no longer does, so call it before each one. Code of the robot, which has no such call,
  /// needs none: there Robot::step() continues the page by the robot's time since the last step, at most 80 ms. Pages
  /// advance in ticks of 8 ms; the remainder is carried over. Does nothing while no page is played.
  void step(int ms);
  /// True from playPage() until the last page has ended.
  bool isMotionPlaying();

 protected:
  DARwInOPMotionManager(webots::Robot* robot, const std::string& customMotionFile, const std::string& dataDirectory);

 private:
  struct Stage;
  Stage* stage_;  // never NULL
};

}  // namespace managers

#endif
