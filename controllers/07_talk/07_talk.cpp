// Says what it feels: that it lies on its face, back or side, stands again, is moved, touched at START, or that its
// battery is low. Lift it, lay it down. Ends after --seconds N, or with Ctrl-C. Its words are printed, too.
#include <cmath>
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

// "--seconds 10" as first argument; without it the example goes on for ever.
static double secondsToRun(int argc, char** argv) {
  return argc > 2 && std::strcmp(argv[1], "--seconds") == 0 ? std::atof(argv[2]) : INFINITY;
}

// Something that must be so for a while before it is felt, and not so for as long before it can be felt again: one bump
// is no fall, and a voltage that trembles around its limit is one low battery.
class Feeling {
 public:
  explicit Feeling(double seconds) : seconds_(seconds) {}
  // True once, when it begins.
  bool begins(bool so, double now) {
    if (so == felt_) since_ = now;
    if (now - since_ < seconds_) return false;
    felt_ = so;
    since_ = now;
    return felt_;
  }

 private:
  const double seconds_;
  double since_ = 0;
  bool felt_ = false;
};

// One sentence after the other: a new one would cut off the one before.
class Voice {
 public:
  explicit Voice(Speaker* speaker) : speaker_(speaker) {}
  void say(const std::string& text) {
    if (waiting_.size() < 3) waiting_.push_back(text);  // what is older than three sentences is no news
  }
  void goOn() {
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
  accelerometer->enable(time_step);
  gyro->enable(time_step);
  button->enable(time_step);
  robot.batterySensorEnable(time_step);

  Speaker* speaker = robot.getSpeaker("Speaker");
  speaker->setLanguage("en-us");
  Voice voice(speaker);
  voice.say("Hello. I say what I feel.");

  // Seconds.
  Feeling face(0.5), back(0.5), side(0.5), upright(1), moved(0.1), touched(0.03), weak(2);
  bool lay = false;
  while (robot.step(time_step) != -1 && robot.getTime() < end) {
    const double now = robot.getTime();
    // Counts: 512 is 0, 128 are 1 g, 1 is 3.6 degrees a second. What is not a number (the board is silent) is never
    // greater or smaller than anything, so nothing is felt then.
    const double* a = accelerometer->getValues();
    const double* w = gyro->getValues();
    if (face.begins(a[1] < 512 - 80, now)) voice.say("I lie on my face.");
    if (back.begins(a[1] > 512 + 80, now)) voice.say("I lie on my back.");
    if (side.begins(std::abs(a[0] - 512) > 80, now)) voice.say("I lie on my side.");
    lay = lay || a[2] < 512 + 30;
    if (upright.begins(a[2] > 512 + 90, now) && lay) {
      voice.say("I am upright again. Thank you.");
      lay = false;
    }
    const double turn = std::abs(w[0] - 512) + std::abs(w[1] - 512) + std::abs(w[2] - 512);
    if (moved.begins(turn > 20, now)) voice.say("Somebody moves me.");
    if (touched.begins(button->getValue() == 1, now)) voice.say("You touched my start button.");
    if (weak.begins(robot.batterySensorGetValue() < 11, now)) voice.say("My battery is low.");
    voice.goOn();
  }
  return EXIT_SUCCESS;
}
