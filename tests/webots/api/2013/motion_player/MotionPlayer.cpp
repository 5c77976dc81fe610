// Plays a motion file for ever.
#include "MotionPlayer.hpp"
#include <webots/utils/Motion.hpp>

#include <cstdlib>
#include <iostream>

using namespace webots;
using namespace std;

MotionPlayer::MotionPlayer() : Robot() {
  mTimeStep = getBasicTimeStep();
}

MotionPlayer::~MotionPlayer() {
}

void MotionPlayer::myStep() {
  int ret = step(mTimeStep);
  if (ret == -1)
    exit(EXIT_SUCCESS);
}

void MotionPlayer::wait(int ms) {
  double startTime = getTime();
  double s = (double)ms / 1000.0;
  while (s + startTime >= getTime())
    myStep();
}
void MotionPlayer::run() {
  cout << "motion player" << endl;
  myStep();
  Motion motion("hand_high.motion");
  motion.setLoop(true);
  motion.play();
  wait(100);
  while (true)
    myStep();
}
