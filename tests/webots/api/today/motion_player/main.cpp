// Starts the controller.
#include <cstdlib>

#include "MotionPlayer.hpp"

using namespace webots;

int main(int argc, char **argv) {
  MotionPlayer *controller = new MotionPlayer();
  controller->run();
  return EXIT_FAILURE;
}
