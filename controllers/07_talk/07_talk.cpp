// Announces by speech: lying on face, back or side, upright again, moved, START pressed, battery low. The texts are
// also printed. Ends after --seconds N, or with Ctrl-C.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>
#include <string>
#include <webots/Accelerometer.hpp>
#include <webots/Gyro.hpp>
#include <webots/Robot.hpp>
#include <webots/Speaker.hpp>
#include <webots/TouchSensor.hpp>

using namespace webots;

// Value of "--seconds 10"; infinity without arguments.
static double secondsToRun(int argc, char** argv) {
  if (argc == 1) return INFINITY;
  char* end = nullptr;
  const double seconds = argc == 3 ? std::strtod(argv[2], &end) : 0;
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0 && end != argv[2] && *end == '\0') return seconds;
  std::fprintf(stderr, "usage: 07_talk [--seconds N]\n");
  std::exit(2);
}

// Debounces a condition: it must hold for some time to become true, and be absent for the same time to become false.
class Debounced {
 public:
  explicit Debounced(double seconds) : seconds_(seconds) {}
  // True once, when the condition becomes true.
  bool begins(bool condition, double now) {
    if (condition == state_) since_ = now;
    if (now - since_ < seconds_) return false;
    state_ = condition;
    since_ = now;
    return state_;
  }

 private:
  const double seconds_;
  double since_ = 0;
  bool state_ = false;
};

// Queue of sentences, because speaking a new one interrupts the current one.
class SpeechQueue {
 public:
  explicit SpeechQueue(Speaker* speaker) : speaker_(speaker) {}
  void add(const std::string& text) {
    if (waiting_.size() < 3) waiting_.push_back(text);  // drop texts that would be out of date
  }
  void update() {
    if (waiting_.empty() || speaker_->isSpeaking()) return;
    std::cout << waiting_.front() << std::endl;
    speaker_->speak(waiting_.front(), 1.0);
    waiting_.pop_front();
  }

 private:
  Speaker* speaker_;
  std::deque<std::string> waiting_;
};

int main(int argc, char** argv) {
  const double end = secondsToRun(argc, argv);
  Robot robot;
  const int time_step = static_cast<int>(robot.getBasicTimeStep());
  Accelerometer* accelerometer = robot.getAccelerometer("Accelerometer");
  Gyro* gyro = robot.getGyro("Gyro");
  TouchSensor* button = robot.getTouchSensor("ButtonStart");
  if (accelerometer == nullptr) {
    std::cerr << "This example needs inertial sensors; servos without a board have none." << std::endl;
    return EXIT_FAILURE;
  }
  accelerometer->enable(time_step);
  gyro->enable(time_step);
  button->enable(time_step);
  robot.batterySensorEnable(time_step);

  Speaker* speaker = robot.getSpeaker("Speaker");
  speaker->setLanguage("en-us");
  SpeechQueue speech(speaker);
  speech.add("Hello. I say what I feel.");

  // Seconds.
  Debounced face(0.5), back(0.5), side(0.5), upright(1), moved(0.1), touched(0.03), weak(2);
  bool lay = false;
  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    const double now = robot.getTime();
    // Counts: 512 is 0, 128 are 1 g, 1 is 3.6 deg/s. Comparisons with NaN (the board does not reply) are false.
    const double* a = accelerometer->getValues();
    const double* w = gyro->getValues();
    if (face.begins(a[1] < 512 - 80, now)) speech.add("I lie on my face.");
    if (back.begins(a[1] > 512 + 80, now)) speech.add("I lie on my back.");
    if (side.begins(std::abs(a[0] - 512) > 80, now)) speech.add("I lie on my side.");
    lay = lay || a[2] < 512 + 30;
    if (upright.begins(a[2] > 512 + 90, now) && lay) {
      speech.add("I am upright again. Thank you.");
      lay = false;
    }
    const double turn = std::abs(w[0] - 512) + std::abs(w[1] - 512) + std::abs(w[2] - 512);
    if (moved.begins(turn > 20, now)) speech.add("Somebody moves me.");
    if (touched.begins(button->getValue() == 1, now)) speech.add("You touched my start button.");
    if (weak.begins(robot.batterySensorGetValue() < 11, now)) speech.add("My battery is low.");
    speech.update();
  }
  return EXIT_SUCCESS;
}
