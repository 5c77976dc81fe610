// The right arm is limp; the left arm mirrors it when you move it. Ends after --seconds N, or with Ctrl-C.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// Value of "--seconds 10"; infinity without arguments.
static double secondsToRun(int argc, char** argv) {
  if (argc == 1) return INFINITY;
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : 0;
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0') return seconds;
  std::fprintf(stderr, "usage: 02_symmetry [--seconds N]\n");
  std::exit(2);
}

int main(int argc, char** argv) {
  const double end = secondsToRun(argc, argv);
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());

  const char* joints[] = {"Shoulder", "ArmUpper", "ArmLower"};
  PositionSensor* right[3];
  Motor* left[3];
  for (int i = 0; i < 3; ++i) {
    right[i] = robot.getPositionSensor(std::string(joints[i]) + "RS");
    right[i]->enable(time_step);
    robot.getMotor(std::string(joints[i]) + "R")->setAvailableTorque(0);  // limp
    left[i] = robot.getMotor(std::string(joints[i]) + "L");
    left[i]->setVelocity(3);  // rad/s
  }
  std::cout << "The right arm is limp now. Move it." << std::endl;

  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    for (int i = 0; i < 3; ++i) {
      const double angle = right[i]->getValue();
      if (std::isnan(angle)) continue;  // unknown: the servo did not reply
      // The arms are mirror images.
      left[i]->setPosition(std::max(left[i]->getMinPosition(), std::min(left[i]->getMaxPosition(), -angle)));
    }
  }
  return EXIT_SUCCESS;
}
