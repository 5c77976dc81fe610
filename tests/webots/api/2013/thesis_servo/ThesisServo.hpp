// Every call of the thesis' Servo class.
#ifndef THESIS_SERVO_HPP
#define THESIS_SERVO_HPP

#include <webots/Robot.hpp>

namespace webots {
  class Servo;
}

class ThesisServo : public webots::Robot {
  public:
    ThesisServo();
    void run();

  private:
    webots::Servo *mNeck;
};

#endif
