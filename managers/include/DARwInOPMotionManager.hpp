// Plays the pages of a motion file: docs/motions.md.
#ifndef DARWIN_OP_MOTION_MANAGER_HPP
#define DARWIN_OP_MOTION_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

/// While a page is played its goals and P gains are those of all twenty joints. They begin where the robot has its
/// goals, so that nothing jumps, and the goals stay when the page has ended; the P gains become the controller's again.
class DARwInOPMotionManager {
 public:
  /// The file is customMotionFile, binary or text ("own": the runtime's own pages); when that is "", motion_4096.bin in
  /// the data directory, and the own pages where there is none.
  explicit DARwInOPMotionManager(webots::Robot* robot, const std::string& customMotionFile = "");
  /// The same file for the same robot; the copy plays nothing yet.
  DARwInOPMotionManager(const DARwInOPMotionManager& other);
  DARwInOPMotionManager& operator=(const DARwInOPMotionManager& other);
  virtual ~DARwInOPMotionManager();

  /// False: the file that was named is missing, or a file is broken. It was said which, and nothing will be played.
  bool isCorrectlyInitialized();
  /// Page 1 to 255. sync: calls Robot::step() with the basic time step until the page and those that follow it have
  /// ended, or until it gives -1. A first pose that is far away is led to slowly, before the page begins. Not sync:
  /// returns at once; step() plays it. While a page is played another one is refused, and this is said.
  void playPage(int id, bool sync = true);
  /// Goes on by this many ms with a page that is not sync; call it before each Robot::step(). What is left over 8 ms is
  /// kept for the next call.
  void step(int ms);
  bool isMotionPlaying();

 protected:
  DARwInOPMotionManager(webots::Robot* robot, const std::string& customMotionFile, const std::string& dataDirectory);

 private:
  struct Stage;
  Stage* stage_;  // never NULL
};

}  // namespace managers

#endif
