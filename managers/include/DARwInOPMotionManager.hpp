// Plays the pages of a motion file. This version cannot yet: isCorrectlyInitialized() is false, nothing moves.
#ifndef DARWIN_OP_MOTION_MANAGER_HPP
#define DARWIN_OP_MOTION_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

class DARwInOPMotionManager {
 public:
  explicit DARwInOPMotionManager(webots::Robot* robot, const std::string& customMotionFile = "");
  virtual ~DARwInOPMotionManager() {}
  bool isCorrectlyInitialized() { return false; }
  /// Returns at once.
  void playPage(int id, bool sync = true);
  void step(int) {}
  bool isMotionPlaying() { return false; }
};

}  // namespace managers

#endif
