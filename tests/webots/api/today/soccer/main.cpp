// Starts the controller.
#include <cstdlib>

#include "Soccer.hpp"

using namespace webots;

int main(int argc, char **argv) {
  Soccer *controller = new Soccer();
  controller->run();
  return EXIT_FAILURE;
}
