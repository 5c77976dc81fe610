// Starts the controller.
#include <webots/Supervisor.hpp>

#include <cstdlib>

#include "EveryMember.hpp"

using namespace webots;

int main(int argc, char **argv) {
  Supervisor *supervisor = new Supervisor();
  useRobot(supervisor);
  useMotors(supervisor);
  useSensors(supervisor);
  useCamera(supervisor);
  useInputs(supervisor);
  useAbsentSensors(supervisor);
  useAbsentActuators(supervisor);
  useWorld(supervisor);
  while (supervisor->step(16) != -1) {
  }
  delete supervisor;
  return EXIT_SUCCESS;
}
