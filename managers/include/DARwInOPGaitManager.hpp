// Walks: docs/gait.md. The robot takes its stance, then steps as the amplitudes say, until stop().
#ifndef DARWIN_OP_GAIT_MANAGER_HPP
#define DARWIN_OP_GAIT_MANAGER_HPP

#include <string>

namespace webots {
class Robot;
}

namespace managers {

/// Moves the joints 1..18, all but the head, from start() until stop() has returned, and never else. One object at a
/// time may walk; a page that is played meanwhile has the joints until its end, and the walk then begins anew. Copies
/// share the robot, and begin at rest.
class DARwInOPGaitManager {
 public:
  /// Enables the gyroscope and reads section [Walking Config] of the file. A file that is not there gives the
  /// defaults; one with a wrong value is named, and the robot will not walk.
  DARwInOPGaitManager(webots::Robot* robot, const std::string& iniFilename);
  DARwInOPGaitManager(const DARwInOPGaitManager& other);
  DARwInOPGaitManager& operator=(const DARwInOPGaitManager& other);
  virtual ~DARwInOPGaitManager();
  /// False: every call does nothing.
  bool isCorrectlyInitialized();

  // In force from the middle of the next step. What is beyond -1..1 is taken as -1 or 1; NaN is ignored.
  /// 1: 20 mm forwards.
  void setXAmplitude(double x);
  /// 1: 40 mm to the left.
  void setYAmplitude(double y);
  /// 1: 50 degrees to the left.
  void setAAmplitude(double a);
  /// True: while turning, keeps facing what is in front and steps around it. Default false.
  void setMoveAimOn(bool on);
  /// True, the default: the gyroscope corrects knees, ankles and hips. Where it rests has to be measured once, while
  /// the robot stands still for 1.6 s: in calls of step() before start(), else after it, before the first step.
  void setBalanceEnable(bool on);

  /// From the next step() on the robot moves gently to its stance if it is in another pose, and then walks.
  void start();
  /// Call it before every Robot::step(), with the same duration. Computes the goals that are due then, one every 8 ms;
  /// what remains is carried over. Under 8 ms: says so once and does nothing. Does not wait.
  void step(int ms);
  /// Goes on to the end of the steps under way, and returns when the robot has its stance again. Meanwhile it calls
  /// Robot::step() with the basic time step, so sensors, keyboard and safety go on: up to one and a half periods of
  /// the gait, 0.9 s; on the way to the stance, the rest of that way. Returns at once when Robot::step() gives -1.
  void stop();

 private:
  struct Walker;
  Walker* walker_;  // never NULL
};

}  // namespace managers

#endif
