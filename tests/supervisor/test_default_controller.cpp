// Default controller of the system tests. Behaviour by the file "plan" in its folder:
//   hold    stretches both knees and holds them until SIGTERM
//   crash   the same, and crashes during it
//   fork    the same, and leaves a process behind that shares its descriptors
//   unresponsive    the same, and then neither steps nor handles SIGTERM
//   once    ends at once
//   sit     stays in the start pose until SIGTERM, and then ends with an error
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <webots/Motor.hpp>
#include <webots/Robot.hpp>

int main() {
  std::string plan;
  std::ifstream{"plan"} >> plan;
  std::cout << "plan " << plan << std::endl;
  if (plan == "once") return 0;
  webots::Robot robot;
  const int step_ms = static_cast<int>(robot.getBasicTimeStep());
  if (plan != "sit") {
    robot.getMotor("LegLowerR")->setPosition(1.2);
    robot.getMotor("LegLowerL")->setPosition(-1.2);
  }
  int steps = 0;
  while (robot.step(step_ms) != -1) {
    if (++steps == 10 && plan == "fork" && fork() == 0)
      for (;;) pause();
    if (steps == 10 && (plan == "crash" || plan == "fork")) std::abort();
    if (steps != 40) continue;
    std::cout << "stands" << std::endl;
    if (plan == "unresponsive") std::signal(SIGTERM, SIG_IGN);
    while (plan == "unresponsive") pause();
  }
  std::cout << "end requested" << std::endl;
  return plan == "sit" ? 1 : 0;
}
