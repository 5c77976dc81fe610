// Lets every joint go with its first command and looks on for ten seconds.
#include <iostream>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

int main() {
  Robot robot;
  const int step_ms = static_cast<int>(robot.getBasicTimeStep());
  int motors = 0;
  for (int i = 0; i < robot.getNumberOfDevices(); ++i)
    if (auto* const motor = dynamic_cast<Motor*>(robot.getDeviceByIndex(i)); motor != nullptr) {
      motor->setAvailableTorque(0);
      ++motors;
    }
  const double start = robot.getTime();
  while (robot.getTime() - start < 10)
    if (robot.step(step_ms) == -1) return 1;
  std::cout << motors << " motors are limp" << std::endl;
  return 0;
}
