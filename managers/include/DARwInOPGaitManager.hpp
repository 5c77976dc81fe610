// Walking. This version cannot yet: isCorrectlyInitialized() is false and nothing moves.
#ifndef DARWIN_OP_GAIT_MANAGER_HPP
#define DARWIN_OP_GAIT_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

class DARwInOPGaitManager {
 public:
  DARwInOPGaitManager(webots::Robot* robot, const std::string& iniFilename);
  virtual ~DARwInOPGaitManager() {}
  bool isCorrectlyInitialized() { return false; }
  /// -1..1 of the greatest step: forwards, sideways, turning.
  void setXAmplitude(double) {}
  void setYAmplitude(double) {}
  void setAAmplitude(double) {}
  void setMoveAimOn(bool) {}
  void setBalanceEnable(bool) {}
  void start() {}
  void step(int) {}
  void stop() {}
};

}  // namespace managers

#endif
