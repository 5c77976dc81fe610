// Takes its stance, walks, and stops: no keys. --seconds N --x X --y Y --a A; forwards for ten seconds without.
#include <DARwInOPGaitManager.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/Accelerometer.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// "--seconds 10": the number after this word, or else `usual`.
static double option(int argc, char** argv, const char* word, double usual) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], word) == 0) return std::atof(argv[i + 1]);
  return usual;
}

int main(int argc, char** argv) {
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  Accelerometer* accelerometer = robot.getAccelerometer("Accelerometer");
  accelerometer->enable(time_step);
  managers::DARwInOPGaitManager gait(&robot, "config.ini");
  if (!gait.isCorrectlyInitialized()) return EXIT_FAILURE;

  gait.setXAmplitude(option(argc, argv, "--x", 1));
  gait.setYAmplitude(option(argc, argv, "--y", 0));
  gait.setAAmplitude(option(argc, argv, "--a", 0));
  gait.start();
  // Before the first step: 2.7 s to the stance, and 1.6 s of standing still for the gyroscope.
  const double end = robot.getTime() + 4.3 + option(argc, argv, "--seconds", 10);
  const int kFallen =
      30;  // steps in which gravity was not where it is in an upright robot, 128 counts above the middle
  int lying = 0;
  while (robot.getTime() < end && lying < kFallen) {
    gait.step(time_step);
    if (robot.step(time_step) == -1) return EXIT_FAILURE;
    // Every step shakes it for a moment. Not a number: the board is silent, and nobody knows.
    lying = accelerometer->getValues()[2] < 550 ? lying + 1 : 0;
  }
  gait.stop();
  const double up = accelerometer->getValues()[2];
  if (std::isnan(up)) std::cout << "It walked; whether it stands, its accelerometer does not say." << std::endl;
  const bool fell = lying >= kFallen || up < 550;
  if (!std::isnan(up)) std::cout << (fell ? "It fell." : "It walked, and stands.") << std::endl;
  return fell ? EXIT_FAILURE : EXIT_SUCCESS;
}
