// The controller of the system tests: swings neck and elbow for a number of steps, prints what it sees.
//   test_controller STEPS [STEP_MS]
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 100;
  webots::Robot robot;
  const int step_ms = argc > 2 ? std::atoi(argv[2]) : static_cast<int>(robot.getBasicTimeStep());
  webots::Motor* const neck = robot.getMotor("Neck");
  webots::Motor* const elbow = robot.getMotor("ArmLowerR");
  webots::PositionSensor* const seen = robot.getPositionSensor("NeckS");
  seen->enable(step_ms);
  std::cout << "ready" << std::endl;
  for (int i = 1; i <= steps; ++i) {
    neck->setPosition(0.5 * std::sin(0.02 * i));
    elbow->setPosition(0.5 + 0.3 * std::sin(0.03 * i));
    if (robot.step(step_ms) == -1) {
      std::cout << "step() = -1 after " << i << " steps" << std::endl;
      return 0;
    }
  }
  std::cout << "done, neck " << seen->getValue() << std::endl;
  return 0;
}
