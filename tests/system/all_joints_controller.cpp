// The controller of same_goals_test: all joints, a motion page and a walk, by time alone and by no sensor. In Python it
// is tests/python/controllers/all_joints, which asks for the same goals bit by bit: change both.
#include <RobotisOp2GaitManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

namespace {

const char* const kJoints[] = {
    "ShoulderR", "ShoulderL", "ArmUpperR", "ArmUpperL", "ArmLowerR", "ArmLowerL", "PelvYR", "PelvYL", "PelvR", "PelvL",
    "LegUpperR", "LegUpperL", "LegLowerR", "LegLowerL", "AnkleR",    "AnkleL",    "FootR",  "FootL",  "Neck",  "Head"};
const int kSweepSteps = 64, kRestSteps = 10, kWalkSteps = 60;
const int kFromSittingToStance = 1;  // page

/// A joint that leaves its place towards the middle of its range, by its own amplitude, and comes back.
struct Sweep {
  Sweep(webots::Motor* moved, double size)
      : motor(moved),
        start(moved->getTargetPosition()),
        amplitude(moved->getMinPosition() + moved->getMaxPosition() > 2 * start ? size : -size) {}
  void set(int step) const { motor->setPosition(start + amplitude * (1 - std::cos(step * 2 * M_PI / kSweepSteps))); }

  webots::Motor* motor;
  double start, amplitude;
};

}  // namespace

int main() {
  webots::Robot robot;
  const int step_ms = static_cast<int>(robot.getBasicTimeStep());
  managers::RobotisOp2MotionManager motion(&robot);
  managers::RobotisOp2GaitManager gait(&robot, "config.ini");
  gait.setBalanceEnable(false);  // which would follow the gyroscope
  std::vector<Sweep> sweeps;
  for (const char* const joint : kJoints)
    sweeps.push_back(Sweep(robot.getMotor(joint), 0.04 + 0.004 * static_cast<double>(sweeps.size())));
  // A page and a walk start at the goals that the robot holds: until it holds the last ones.
  const auto rest = [&] {
    for (int i = 0; i < kRestSteps; ++i)
      if (robot.step(step_ms) == -1) std::exit(EXIT_FAILURE);
  };

  for (int i = 1; i <= kSweepSteps; ++i) {
    for (const Sweep& sweep : sweeps) sweep.set(i);
    if (robot.step(step_ms) == -1) return EXIT_FAILURE;
  }
  rest();
  motion.playPage(kFromSittingToStance);
  rest();
  gait.setXAmplitude(0.5);
  gait.start();
  for (int i = 0; i < kWalkSteps; ++i) {
    gait.step(step_ms);
    if (robot.step(step_ms) == -1) return EXIT_FAILURE;
  }
  gait.stop();
  rest();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
