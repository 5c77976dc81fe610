// Looks for a ball, walks to it, kicks it.
#include "Soccer.hpp"
#include <webots/Motor.hpp>
#include <webots/LED.hpp>
#include <webots/Camera.hpp>
#include <webots/Accelerometer.hpp>
#include <webots/Gyro.hpp>
#include <DARwInOPMotionManager.hpp>
#include <DARwInOPGaitManager.hpp>
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

Soccer::Soccer() : Robot() {
  mTimeStep = getBasicTimeStep();
  mEyeLED = getLED("EyeLed");
  mHeadLED = getLED("HeadLed");
  mHeadLED->set(0x00FF00);
  mBackLedRed = getLED("BackLedRed");
  mBackLedGreen = getLED("BackLedGreen");
  mBackLedBlue = getLED("BackLedBlue");
  mCamera = getCamera("Camera");
  mCamera->enable(2 * mTimeStep);
  mAccelerometer = getAccelerometer("Accelerometer");
  mAccelerometer->enable(mTimeStep);
  mGyro = getGyro("Gyro");
  mGyro->enable(mTimeStep);
  for (int i = 0; i < NMOTORS; i++) {
    mMotors[i] = getMotor(motorNames[i]);
    mMotors[i]->enablePosition(mTimeStep);
    mMin[i] = mMotors[i]->getMinPosition();
    mMax[i] = mMotors[i]->getMaxPosition();
  }
  mMotionManager = new DARwInOPMotionManager(this);
  mGaitManager = new DARwInOPGaitManager(this, "config.ini");
  mVisionManager = new DARwInOPVisionManager(mCamera->getWidth(), mCamera->getHeight(), 28, 20, 50, 45, 0, 30);
}

Soccer::~Soccer() {
}

void Soccer::myStep() {
  int ret = step(mTimeStep);
  if (ret == -1)
    exit(EXIT_SUCCESS);
}

void Soccer::wait(int ms) {
  double startTime = getTime();
  double s = (double)ms / 1000.0;
  while (s + startTime >= getTime())
    myStep();
}
bool Soccer::getBallCenter(double &x, double &y) {
  static const int width = mCamera->getWidth(), height = mCamera->getHeight();
  bool found = mVisionManager->getBallCenter(x, y, mCamera->getImage());
  x = 2.0 * x / width - 1.0;
  y = 2.0 * y / height - 1.0;
  return found;
}

void Soccer::run() {
  myStep();
  mMotionManager->playPage(1);
  mMotionManager->playPage(24);
  mMotionManager->playPage(9);
  mGaitManager->start();
  mGaitManager->step(mTimeStep);
  while (true) {
    double x, y, neck, head;
    const double acc = mAccelerometer->getValues()[1];
    if (acc < 512.0 - 80.0 || acc > 512.0 + 80.0)
      mMotionManager->playPage(acc < 512.0 ? 10 : 11);
    if (getBallCenter(x, y)) {
      mEyeLED->set(0x0000FF);
      neck = 0.25 * x;
      head = 0.25 * y;
      mGaitManager->setXAmplitude(1.0);
      mGaitManager->setAAmplitude(neck);
    } else {
      mEyeLED->set(0xFF0000);
      mGaitManager->setXAmplitude(0.0);
      mGaitManager->setAAmplitude(-0.3);
      neck = 0.0;
      head = 0.35 + 0.5 * sin(3.0 * getTime());
    }
    mGaitManager->step(mTimeStep);
    mMotors[18]->setPosition(neck < mMin[18] ? mMin[18] : neck > mMax[18] ? mMax[18] : neck);
    mMotors[19]->setPosition(head < mMin[19] ? mMin[19] : head > mMax[19] ? mMax[19] : head);
    myStep();
  }
}
