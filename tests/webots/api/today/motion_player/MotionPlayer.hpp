// Plays a motion file for ever.
#ifndef MOTION_PLAYER_HPP
#define MOTION_PLAYER_HPP

#include <webots/Robot.hpp>

class MotionPlayer : public webots::Robot {
  public:
    MotionPlayer();
    virtual ~MotionPlayer();
    void run();

  private:
    int mTimeStep;

    void myStep();
    void wait(int ms);
};

#endif
