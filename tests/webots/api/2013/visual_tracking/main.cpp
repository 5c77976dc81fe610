// Starts the controller.
#include <cstdlib>

#include "VisualTracking.hpp"

using namespace webots;

int main(int argc, char **argv) {
  VisualTracking *controller = new VisualTracking();
  controller->run();
  return EXIT_FAILURE;
}
