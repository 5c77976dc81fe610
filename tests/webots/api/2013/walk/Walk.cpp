// Walks as the arrow keys say, and gets up after a fall.
#include "Walk.hpp"
#include <webots/LED.hpp>
#include <webots/Accelerometer.hpp>
#include <webots/Gyro.hpp>
#include <webots/Motor.hpp>
#include <DARwInOPMotionManager.hpp>
#include <DARwInOPGaitManager.hpp>

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

Walk::Walk() : Robot(), mIsWalking(false) {
  mTimeStep = getBasicTimeStep();
  getLED("HeadLed")->set(0xFF0000);
  getLED("EyeLed")->set(0x00FF00);
  mAccelerometer = getAccelerometer("Accelerometer");
  mAccelerometer->enable(mTimeStep);
  mGyro = getGyro("Gyro");
  mGyro->enable(mTimeStep);
  for (int i = 0; i < NMOTORS; i++) {
    mMotors[i] = getMotor(motorNames[i]);
    mMotors[i]->enablePosition(mTimeStep);
  }
  keyboardEnable(mTimeStep);
  mMotionManager = new DARwInOPMotionManager(this);
  mGaitManager = new DARwInOPGaitManager(this, "config.ini");
}

Walk::~Walk() {
}

void Walk::myStep() {
  int ret = step(mTimeStep);
  if (ret == -1)
    exit(EXIT_SUCCESS);
}

void Walk::wait(int ms) {
  double startTime = getTime();
  double s = (double)ms / 1000.0;
  while (s + startTime >= getTime())
    myStep();
}
void Walk::checkIfFallen() {
  static int faceDown = 0, faceUp = 0;
  const double *acc = mAccelerometer->getValues();
  faceDown = acc[1] < 432.0 ? faceDown + 1 : 0;
  faceUp = acc[1] > 592.0 ? faceUp + 1 : 0;
  if (faceDown > 100 || faceUp > 100) {
    mMotionManager->playPage(faceDown > 100 ? 10 : 11);
    mMotionManager->playPage(9);
    faceDown = faceUp = 0;
  }
}

void Walk::run() {
  myStep();
  mMotionManager->playPage(9);
  wait(200);
  while (true) {
    checkIfFallen();
    mGaitManager->setXAmplitude(0.0);
    mGaitManager->setAAmplitude(0.0);
    int key = 0;
    while ((key = keyboardGetKey()) != 0) {
      switch (key) {
        case ' ':
          if (mIsWalking)
            mGaitManager->stop();
          else
            mGaitManager->start();
          mIsWalking = !mIsWalking;
          break;
        case KEYBOARD_UP:
          mGaitManager->setXAmplitude(1.0);
          break;
        case KEYBOARD_DOWN:
          mGaitManager->setXAmplitude(-1.0);
          break;
        case KEYBOARD_RIGHT:
          mGaitManager->setAAmplitude(-0.5);
          break;
        case KEYBOARD_LEFT:
          mGaitManager->setAAmplitude(0.5);
          break;
      }
    }
    mGaitManager->step(mTimeStep);
    myStep();
  }
}
