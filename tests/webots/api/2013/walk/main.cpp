// Starts the controller.
#include <cstdlib>

#include "Walk.hpp"

using namespace webots;

int main(int argc, char **argv) {
  Walk *controller = new Walk();
  controller->run();
  return EXIT_FAILURE;
}
