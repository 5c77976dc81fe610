// Left arm mirrors the limp right arm.
#include "Symmetry.hpp"
#include <webots/LED.hpp>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#ifdef CROSSCOMPILATION
#include <webots/Speaker.hpp>
#else
#error "CROSSCOMPILATION must be defined"
#endif

#include <cassert>
#include <cstdlib>
#include <cmath>
#include <iostream>
#include <fstream>

using namespace webots;
using namespace std;

#define NMOTORS 20

static const char *motorNames[NMOTORS] = {
  "ShoulderR", "ShoulderL", "ArmUpperR", "ArmUpperL", "ArmLowerR", "ArmLowerL", "PelvYR", "PelvYL", "PelvR", "PelvL",
  "LegUpperR", "LegUpperL", "LegLowerR", "LegLowerL", "AnkleR", "AnkleL", "FootR", "FootL", "Neck", "Head"
};

static double clampValue(double value, double min, double max) {
  assert(min <= max);
  return value < min ? min : value > max ? max : value;
}

Symmetry::Symmetry() : Robot() {
  mTimeStep = getBasicTimeStep();
  mEyeLED = getLED("EyeLed");
  mHeadLED = getLED("HeadLed");
  mSpeaker = getSpeaker("Speaker");
  for (int i = 0; i < NMOTORS; i++) {
    mMotors[i] = getMotor(motorNames[i]);
    mSensors[i] = getPositionSensor(string(motorNames[i]) + "S");
    mSensors[i]->enable(mTimeStep);
    mMin[i] = mMotors[i]->getMinPosition();
    mMax[i] = mMotors[i]->getMaxPosition();
  }
}

Symmetry::~Symmetry() {
}

void Symmetry::myStep() {
  int ret = step(mTimeStep);
  if (ret == -1)
    exit(EXIT_SUCCESS);
}

void Symmetry::wait(int ms) {
  double startTime = getTime();
  double s = (double)ms / 1000.0;
  while (s + startTime >= getTime())
    myStep();
}
void Symmetry::run() {
  cout << "symmetry" << endl;
  mSpeaker->speak("I copy the right arm", 1.0);
  myStep();
  for (int i = 0; i < 6; i += 2)
    mMotors[i]->setAvailableTorque(0.0);
  wait(200);
  while (true) {
    for (int i = 0; i < 6; i += 2)
      mMotors[i + 1]->setPosition(clampValue(-mSensors[i]->getValue(), mMin[i + 1], mMax[i + 1]));
    myStep();
  }
}
