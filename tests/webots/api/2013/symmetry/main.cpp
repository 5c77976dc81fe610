// Starts the controller.
#include <cstdlib>

#include "Symmetry.hpp"

using namespace webots;

int main(int argc, char **argv) {
  Symmetry *controller = new Symmetry();
  controller->run();
  return EXIT_FAILURE;
}
