// Walks, and ends in the middle of a step.
//   ending_walk return|exit|exception|SIGINT|SIGTERM MS     MS after the start of a gait period
#include <RobotisOp2GaitManager.hpp>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <webots/Robot.hpp>

using namespace webots;

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  const std::string how = argv[1];
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  managers::RobotisOp2GaitManager gait(&robot, "missing.ini");
  gait.setXAmplitude(1);
  gait.start();
  // 2.7 s to the stance, 1.6 s of calibration, four steps.
  const double end = robot.getTime() + 4.3 + 1.2 + std::atof(argv[2]) / 1000;
  while (robot.getTime() < end) {
    gait.step(time_step);
    if (robot.step(time_step) == -1) return EXIT_FAILURE;
  }
  std::cout << "ends at " << robot.getTime() << " s" << std::endl;
  if (how == "return") return EXIT_SUCCESS;
  if (how == "exit") std::exit(EXIT_SUCCESS);
  if (how == "exception") throw std::runtime_error("a mistake");
  std::raise(how == "SIGINT" ? SIGINT : SIGTERM);
  gait.step(time_step);
  return robot.step(time_step) == -1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
