// Starts and stops a walk with the space bar, as upstream's walk does. Ends 400 steps after the first start.
#include <RobotisOp2GaitManager.hpp>
#include <cstdlib>
#include <iostream>
#include <webots/Keyboard.hpp>
#include <webots/Robot.hpp>

using namespace webots;

int main() {
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  Keyboard* const keyboard = robot.getKeyboard();
  keyboard->enable(time_step);
  managers::RobotisOp2GaitManager gait(&robot, "config.ini");
  bool walks = false;
  int starts = 0, stops = 0, steps = 0;
  while (steps < 400 && robot.step(time_step) != -1) {
    for (int key = keyboard->getKey(); key >= 0; key = keyboard->getKey()) {
      if (key != ' ') continue;
      walks ? gait.stop() : gait.start();
      ++(walks ? stops : starts);
      walks = !walks;
    }
    gait.step(time_step);
    if (starts > 0) ++steps;
  }
  std::cout << "starts: " << starts << ", stops: " << stops << std::endl;
  return EXIT_SUCCESS;
}
