// The LEDs follow the push buttons on the back. Press MODE only briefly: held for 0.25 s it turns the torque of all
// joints off. Ends after --seconds N, or with Ctrl-C.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/LED.hpp>
#include <webots/Robot.hpp>
#include <webots/TouchSensor.hpp>

using namespace webots;

// Value of "--seconds 10"; infinity without arguments.
static double secondsToRun(int argc, char** argv) {
  if (argc == 1) return INFINITY;
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : 0;
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0') return seconds;
  std::fprintf(stderr, "usage: 03_leds_and_buttons [--seconds N]\n");
  std::exit(2);
}

int main(int argc, char** argv) {
  const double end = secondsToRun(argc, argv);
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());

  TouchSensor* mode = robot.getTouchSensor("ButtonMode");
  TouchSensor* start = robot.getTouchSensor("ButtonStart");
  if (mode == nullptr) {
    std::cerr << "This example needs LEDs and buttons; servos without a board have none." << std::endl;
    return EXIT_FAILURE;
  }
  mode->enable(time_step);
  start->enable(time_step);
  LED* eyes = robot.getLED("EyeLed");
  LED* head = robot.getLED("HeadLed");
  LED* red = robot.getLED("BackLedRed");
  LED* green = robot.getLED("BackLedGreen");

  int presses = 0;
  bool was_pressed = false;
  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    // 1 pressed, 0 released, NaN unknown.
    const bool mode_pressed = mode->getValue() == 1;
    const bool start_pressed = start->getValue() == 1;
    eyes->set(start_pressed ? 0x00FF00 : 0x0000FF);
    head->set(mode_pressed ? 0xFF0000 : 0x00FF00);
    red->set(mode_pressed);
    green->set(start_pressed);
    if (start_pressed && !was_pressed) std::cout << "START pressed " << ++presses << " times" << std::endl;
    was_pressed = start_pressed;
  }
  return EXIT_SUCCESS;
}
