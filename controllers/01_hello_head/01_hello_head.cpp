// Nods and turns the head, and prints its position. Ends after --seconds N, or with Ctrl-C.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// Value of "--seconds 10"; infinity without arguments.
static double secondsToRun(int argc, char** argv) {
  if (argc == 1) return INFINITY;
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : 0;
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0') return seconds;
  std::fprintf(stderr, "usage: 01_hello_head [--seconds N]\n");
  std::exit(2);
}

int main(int argc, char** argv) {
  const double end = secondsToRun(argc, argv);
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());

  Motor* neck = robot.getMotor("Neck");
  Motor* head = robot.getMotor("Head");
  PositionSensor* neck_sensor = robot.getPositionSensor("NeckS");
  PositionSensor* head_sensor = robot.getPositionSensor("HeadS");
  neck_sensor->enable(time_step);
  head_sensor->enable(time_step);

  double next_print = 0;
  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    const double t = robot.getTime();
    neck->setPosition(0.6 * std::sin(2 * M_PI * t / 4));        // left and right, 4 s
    head->setPosition(0.3 + 0.2 * std::sin(2 * M_PI * t / 2));  // up and down, 2 s
    if (t >= next_print) {
      std::printf("%5.1f s  neck %+.3f rad (goal %+.3f)  head %+.3f rad (goal %+.3f)\n", t, neck_sensor->getValue(),
                  neck->getTargetPosition(), head_sensor->getValue(), head->getTargetPosition());
      next_print += 0.5;
    }
  }
  return EXIT_SUCCESS;
}
