// Every call of the thesis' Servo class.
#include "ThesisServo.hpp"
#include <webots/Servo.hpp>

#include <cstdlib>

using namespace webots;
using namespace std;

ThesisServo::ThesisServo() : Robot() {
  mNeck = getServo("Neck");
  mNeck->enablePosition(16);
  mNeck->enableMotorForceFeedback(16);
}

void ThesisServo::run() {
  mNeck->setPosition(0.1);
  mNeck->setVelocity(1.0);
  mNeck->setAcceleration(5.0);
  mNeck->setMotorForce(2.0);
  mNeck->setControlP(4.0);
  while (step(16) != -1) {
    double sum = mNeck->getPosition() + mNeck->getMotorForceFeedback() + mNeck->getTargetPosition();
    if (mNeck->getType() != Servo::ROTATIONAL || sum != sum || mNeck->getSamplingPeriod() != 16)
      exit(EXIT_FAILURE);
  }
  mNeck->setForce(0.0);
  mNeck->disablePosition();
  mNeck->disableMotorForceFeedback();
  exit(EXIT_SUCCESS);
}
