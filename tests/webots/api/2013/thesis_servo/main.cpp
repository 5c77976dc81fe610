// Starts the controller.
#include <cstdlib>

#include "ThesisServo.hpp"

using namespace webots;

int main(int argc, char **argv) {
  ThesisServo *controller = new ThesisServo();
  controller->run();
  return EXIT_FAILURE;
}
