// Walks as directed by the arrow keys, and gets up after a fall; space starts and stops. Without keys, for a fixed
// time: --seconds 10 --x 1 --y 0 --a 0.
#include <DARwInOPGaitManager.hpp>
#include <DARwInOPMotionManager.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <webots/Accelerometer.hpp>
#include <webots/Keyboard.hpp>
#include <webots/Robot.hpp>

using namespace webots;

// Pages of the motion file, docs/motions.md.
static const int kStandUp = 9, kGetUpFromFront = 10, kGetUpFromBack = 11;

// The number after an option such as "--seconds 10", or `default_value`.
static double option(int argc, char** argv, const char* word, double default_value) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], word) == 0) return std::atof(argv[i + 1]);
  return default_value;
}

// False for an unknown option or one without a number.
static bool areKnown(int argc, char** argv) {
  for (int i = 1; i < argc; i += 2) {
    const char* const word = argv[i];
    const bool known = std::strcmp(word, "--seconds") == 0 || std::strcmp(word, "--x") == 0 ||
                       std::strcmp(word, "--y") == 0 || std::strcmp(word, "--a") == 0;
    if (!known || i + 1 == argc) return false;
    char* end = nullptr;
    std::strtod(argv[i + 1], &end);
    if (end == argv[i + 1] || *end != '\0') return false;
  }
  return true;
}

// Requests of the keys since the last step.
class Keys {
 public:
  explicit Keys(Keyboard* keyboard) : keyboard_(keyboard) {}
  double x = 0, a = 0;  // forwards, to the left: -1 to 1
  bool space = false;   // pressed in this step
  void read() {
    x = a = 0;
    bool down = false;
    for (int key = keyboard_->getKey(); key != -1; key = keyboard_->getKey()) switch (key) {
        case ' ':
          down = true;
          break;
        case Keyboard::UP:
          x = 1;
          break;
        case Keyboard::DOWN:
          x = -1;
          break;
        case Keyboard::LEFT:
          a = 0.5;
          break;
        case Keyboard::RIGHT:
          a = -0.5;
          break;
      }
    space = down && !was_down_;
    was_down_ = down;
  }

 private:
  Keyboard* keyboard_;
  bool was_down_ = false;
};

// Fall detection: gravity along the front axis instead of the vertical one for 0.5 s. 512 counts are 0 g, 128 are 1 g:
// on its face the robot reads 384 and 512, upright 512 and 640. NaN (the board does not reply) is not a fall.
class Fall {
 public:
  // The page for getting up; 0: not on face or back.
  int page(const double* acceleration) {
    const double front = acceleration[1], height = acceleration[2];
    // By more than 60 degrees. Steps, and legs that move in the air, give short peaks only.
    const bool tilted = height < 512 + 64;
    lies_ = tilted ? lies_ + 1 : 0;
    stands_ = tilted ? 0 : stands_ + 1;
    face_ = tilted && front < 512 - 80 ? face_ + 1 : std::max(0, face_ - 1);
    back_ = tilted && front > 512 + 80 ? back_ + 1 : std::max(0, back_ - 1);
    return face_ > kSteps ? kGetUpFromFront : back_ > kSteps ? kGetUpFromBack : 0;
  }
  bool isOver() const { return stands_ > 2 * kSteps; }
  bool needsHelp() const { return lies_ > 8 * kSteps; }  // on a side: no page for it

 private:
  static const int kSteps = 30;
  int face_ = 0, back_ = 0, lies_ = 0, stands_ = 0;
};

int main(int argc, char** argv) {
  if (!areKnown(argc, argv)) {  // before the robot moves
    std::cerr << "usage: 05_walk [--seconds N] [--x X] [--y Y] [--a A]; without any of these, keys steer" << std::endl;
    return 2;
  }
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  Accelerometer* accelerometer = robot.getAccelerometer("Accelerometer");  // null on servos without a board
  if (accelerometer != nullptr) accelerometer->enable(time_step);
  managers::DARwInOPMotionManager motion(&robot);
  managers::DARwInOPGaitManager gait(&robot, "config.ini");
  if (!gait.isCorrectlyInitialized()) return EXIT_FAILURE;

  const bool scripted = argc > 1;
  Keys keys(robot.getKeyboard());
  Fall fall;
  int falls = 0, tries = 0;
  bool walks = scripted;
  double end = INFINITY;
  if (scripted) {
    gait.setXAmplitude(option(argc, argv, "--x", 1));
    gait.setYAmplitude(option(argc, argv, "--y", 0));
    gait.setAAmplitude(option(argc, argv, "--a", 0));
    gait.start();
    // Before the first step: 2.7 s to the stance, 1.6 s gyroscope calibration.
    end = robot.getTime() + 4.3 + option(argc, argv, "--seconds", 10);
  } else {
    std::cout << "Space starts and stops the walk; the arrow keys say where to." << std::endl;
    robot.getKeyboard()->enable(time_step);
    motion.playPage(kStandUp);
  }

  while (robot.getTime() < end) {
    if (!scripted) {
      keys.read();
      gait.setXAmplitude(keys.x);
      gait.setAAmplitude(keys.a);
      if (keys.space) {
        walks = !walks;
        walks ? gait.start() : gait.stop();
      }
    }
    gait.step(time_step);
    if (robot.step(time_step) == -1) return scripted ? EXIT_FAILURE : EXIT_SUCCESS;

    const int page = accelerometer != nullptr ? fall.page(accelerometer->getValues()) : 0;
    if (fall.isOver()) tries = 0;
    if (fall.needsHelp() || (page != 0 && ++tries > 3)) {  // or it is being carried
      std::cout << "It cannot get up: help it." << std::endl;
      gait.stop();
      return EXIT_FAILURE;
    }
    if (page == 0) continue;
    std::cout << (page == kGetUpFromFront ? "It fell on its face." : "It fell on its back.") << std::endl;
    if (!motion.isCorrectlyInitialized()) return EXIT_FAILURE;  // no page for getting up
    ++falls;
    motion.playPage(page);
    motion.playPage(kStandUp);  // the walk restarts automatically
    fall = Fall();
  }

  gait.stop();
  const double up = accelerometer != nullptr ? accelerometer->getValues()[2] : NAN;  // 640 upright
  if (std::isnan(up))
    std::cout << "It walked. Its orientation is unknown: there is no accelerometer reading." << std::endl;
  else if (up < 550)
    std::cout << "It fell." << std::endl;
  else if (falls > 0)
    std::cout << "It walked, fell " << falls << " times, and stands." << std::endl;
  else
    std::cout << "It walked, and stands." << std::endl;
  return falls > 0 || up < 550 ? EXIT_FAILURE : EXIT_SUCCESS;
}
