// The head follows a ball.
#include "VisualTracking.hpp"
#include <webots/Motor.hpp>
#include <webots/LED.hpp>
#include <webots/Camera.hpp>
#include <DARwInOPVisionManager.hpp>

#include <cassert>
#include <cstdlib>
#include <cmath>
#include <iostream>
#include <fstream>

using namespace webots;
using namespace managers;
using namespace std;

#define NMOTORS 20

static const char *motorNames[NMOTORS] = {
  "ShoulderR", "ShoulderL", "ArmUpperR", "ArmUpperL", "ArmLowerR", "ArmLowerL", "PelvYR", "PelvYL", "PelvR", "PelvL",
  "LegUpperR", "LegUpperL", "LegLowerR", "LegLowerL", "AnkleR", "AnkleL", "FootR", "FootL", "Neck", "Head"
};

VisualTracking::VisualTracking() : Robot() {
  mTimeStep = getBasicTimeStep();
  mEyeLED = getLED("EyeLed");
  mHeadLED = getLED("HeadLed");
  mCamera = getCamera("Camera");
  mCamera->enable(2 * mTimeStep);
  for (int i = 0; i < NMOTORS; i++)
    mMotors[i] = getMotor(motorNames[i]);
  mVisionManager =
    new DARwInOPVisionManager(mCamera->getWidth(), mCamera->getHeight(), 355, 15, 60, 15, 0, 30);
}

VisualTracking::~VisualTracking() {
}

void VisualTracking::myStep() {
  int ret = step(mTimeStep);
  if (ret == -1)
    exit(EXIT_SUCCESS);
}

void VisualTracking::wait(int ms) {
  double startTime = getTime();
  double s = (double)ms / 1000.0;
  while (s + startTime >= getTime())
    myStep();
}
void VisualTracking::run() {
  double horizontal = 0.0, vertical = 0.0;
  const int width = mCamera->getWidth(), height = mCamera->getHeight();
  wait(100);
  while (true) {
    double x, y;
    bool found = mVisionManager->getBallCenter(x, y, mCamera->getImage());
    mEyeLED->set(found ? 0x00FF00 : 0xFF0000);
    if (found) {
      horizontal -= 0.1 * (2.0 * x / width - 1.0);
      vertical -= 0.1 * (2.0 * y / height - 1.0);
    } else
      vertical += 0.01;  // runs out of the joint's range: the runtime must clamp it
    mMotors[18]->setPosition(horizontal);
    mMotors[19]->setPosition(vertical);
    myStep();
  }
}
